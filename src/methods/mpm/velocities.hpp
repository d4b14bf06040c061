// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Smooth nodal velocities for the filter of step 5: v_i^(2) = 2 v_i - sum m N_i v(x_p) / M_i, the velocity before the step
/// of second order in the particles' own (full mass matrix, FMPM(2): Nairn and Hammerquist 2021), from the sums that prepare_cells left at the corners. No effect
/// without the filter.
template <int dim>
void smooth_velocities(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid);

/// Steps 5 and 6: the momentum that the corners get from the particles with the corrected acceleration, from the moments
/// alone: sum m N_k (v + dt a(x)) with a linear in x needs only sums of m, m x, m x x, m v, m v x. The filter's part of it
/// is linear, too, and sums to zero over each cell (in space: patch).
template <int dim>
void spread_new_momentum(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

/// The velocities that conditions at nodes prescribe, when the coming step begins and when it ends.
template <int dim>
void prescribe_velocities(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace);

/// Steps 7 and 8: the nodes' velocities from that momentum, with the supports, those that move in this stage at these velocities (m/s).
template <int dim>
void gather_new_velocities(const problem::Model<dim>& model, const std::vector<Vec<dim>>& motions, BodyGrid<dim>& grid);

/// Update stress first: the nodal velocities at a time `ahead` (s) after the beginning of the step, v + ahead a, with the
/// supports.
template <int dim>
void predict_velocities(const problem::Model<dim>& model, Real ahead, const std::vector<Vec<dim>>& motions, BodyGrid<dim>& grid);

}  // namespace berm::mpm
