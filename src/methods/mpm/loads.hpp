// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Step 1: nodal forces of the tractions, f_i = sum_l N_i(x_l) f_l over the load points in the node's cells. In a cell with
/// nodes without mass (its last particles have left through another face than the load point) the nodes with mass share the
/// force in proportion to their shape functions. Throws RunError where none has mass: the loaded soil is gone.
template <int dim>
void spread_tractions(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace);

/// Step 9: load points move with the soil, by the same weighted velocities that move the particles. Throws RunError where
/// one leaves the mesh.
template <int dim>
void move_load_points(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
