// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Number of steps after which the time step is computed again.
constexpr BigIndex steps_between_time_steps = 16;

/// courant times the minimum of height / (c + v) over the cells with particles, s: c = sqrt(M / density) the speed of
/// pressure waves, v the maximum speed of a node or rigid body. Throws RunError where speeds are not finite, or so large
/// that the time step is less than a thousandth of that at rest.
template <int dim>
Real stable_time_step(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace);

}  // namespace berm::mpm
