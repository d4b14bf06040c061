// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Finds State::stable_dt where it does not hold any more, every sixteenth step. Problems that march together do this before any of them takes its step.
template <int dim>
void find_stable_time_step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

/// A step of the stable time step, or of the one that the caller allows where that is shorter.
template <int dim>
void take_step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

/// Both: advances the state by one time step: modified update-stress-last with frictional contact corrected in steps 4 and 8 (paper, section 2.2,
/// steps 1-11). Throws RunError where a particle leaves the mesh.
template <int dim>
void step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
