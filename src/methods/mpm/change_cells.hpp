// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Moves the particles that have left their cells to their new ones, in the order of their old ones, and sums the moments of these cells anew. Throws RunError for a
/// particle that has left the mesh.
template <int dim>
void change_cells(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);

}  // namespace berm::mpm
