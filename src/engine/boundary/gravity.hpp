// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::boundary {

/// Gravity (m/s2) at a time: it increases linearly from zero over its ramp, s.
template <int dim>
Vec<dim> ramped_gravity(const Vec<dim>& gravity, Real ramp, Real time)
{
  return ramp > time ? Vec<dim>(gravity * (time / ramp)) : gravity;
}

}  // namespace berm::boundary
