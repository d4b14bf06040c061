// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Number of steps after which the time step is computed again.
constexpr BigIndex steps_between_time_steps = 16;

/// The part of the longest stable time step of the mesh, and of the time that a wave needs across the smallest height, that a step takes where a case does not
/// set mpm.courant: the longer of both.
constexpr Real default_stable_fraction = 0.75, default_courant = 0.5;

/// The time step, s, and what it is of a mesh and its soil where the case sets no mpm.courant and no spring is in a drive: lengths of time that belong to the mesh, like that in which a
/// gap closes, are counted in the second.
struct TimeSteps {
  Real stable, by_default;
};

/// length / (c + v), s: c = sqrt(M / density) the speed of pressure waves, v the maximum speed of a node or rigid body; length is courant times the smallest
/// height of the cells with particles or default_stable_fraction of Body::critical_length. Throws RunError where speeds are not finite, or so large that the time
/// step is less than a thousandth of that at rest.
template <int dim>
TimeSteps stable_time_steps(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace);

/// What to try where a run has become unstable: `a smaller mpm.courant (now 0.5)`.
std::string smaller_step(const settings::MpmSettings& settings);

}  // namespace berm::mpm
