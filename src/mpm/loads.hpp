// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Step 1: the forces of the tractions at the nodes, f_i = sum_l N_i(x_l) f_l over the load points in the node's cells. In a cell in which nodes have no
/// mass (its last particles have left through another face than the load point) the nodes with mass share the force as their shape functions are.
/// Throws RunError where none has mass: the soil that the load lay on is gone.
template <int dim>
void spread_tractions(const problem::Model<dim>& model, const problem::State<dim>& state, Work<dim>& work);

/// Step 9: load points move with the soil, by the same shares of the velocities that move the particles. Throws RunError where one leaves the mesh.
template <int dim>
void move_load_points(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work);

}  // namespace berm::mpm
