// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::boundary {

/// Local damping force, N/m or N: `factor` times the magnitude of the unbalanced force in one direction, opposed to the
/// velocity there (Cundall 1987; docs/theory.md, section 6).
inline Real local_damping(Real factor, Real force, Real velocity)
{
  return velocity != 0 ? -factor * std::abs(force) * (velocity > 0 ? 1 : -1) : 0;
}

}  // namespace berm::boundary
