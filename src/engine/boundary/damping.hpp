// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

namespace berm::boundary {

/// Local damping force, N/m or N: `factor` times the magnitude of the unbalanced force in one direction, opposed to the
/// velocity there. T: Real, or Components for all directions (Cundall 1987; docs/theory/method.md, Damping and time step).
template <class T>
[[gnu::always_inline]] inline T local_damping(Real factor, const T& force, const T& velocity)
{
  const T size = factor * magnitude(force);
  return velocity > T{} ? -size : velocity < T{} ? size : T{};
}

}  // namespace berm::boundary
