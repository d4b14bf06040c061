// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Advances the state by one time step: modified update-stress-last with frictional contact corrected in steps 4 and 8 (paper, section 2.2,
/// steps 1-11). Throws RunError where a particle leaves the mesh.
template <int dim>
void step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
