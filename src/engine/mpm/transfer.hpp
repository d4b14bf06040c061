// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// For step 1, at the end of the step before: the moments of a cell with particles, and its contributions to its corners: mass sum m N_k and momentum sum m v N_k. Compiled once for all callers, so
/// that a run and its resumption have the same bits.
template <int dim>
[[gnu::noinline]] void sum_moments_of(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell,
                                      BodyGrid<dim>& grid);

/// That of all cells with particles.
template <int dim>
void sum_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Step 1: nodes gather mass and velocity v = momentum / mass from their cells, always in the same order. A node whose mass
/// is round-off has mass 0.
template <int dim>
void gather_mass_and_momentum(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid);

/// The viscous mean stress of the cells of a body that can yield, eta h div(v) with the means of h and div(v), before the step,
/// over the cells of the patch. Computed once a step, because forces and the work on the particles use the same.
template <int dim>
void find_viscous_stress(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Step 1, equation 2: the internal force of each cell on its corners, -sum V sigma grad N. With the volumetric projection
/// the cell's mean stress is replaced by the volume average over its patch, the same average that the strain gets, so that
/// strain and force stay conjugate. The viscous mean stress is added.
template <int dim>
void spread_internal_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Smooth nodal velocities for the filter of step 5: v_i^(2) = 2 v_i - sum m N_i v(x_p) / M_i, the velocity before the step
/// of second order in the particles' own (full mass matrix, FMPM(2): Nairn and Hammerquist 2021), from the moments alone. No
/// effect without the filter.
template <int dim>
void smooth_velocities(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Steps 5 and 6: the momentum that the corners get from the particles with the corrected acceleration, from the moments
/// alone: sum m N_k (v + dt a(x)) with a linear in x needs only sums of m, m x, m x x, m v, m v x. The filter's part of it
/// is linear, too.
template <int dim>
void spread_new_momentum(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

/// Steps 7 and 8: the nodes' velocities from that momentum, with the supports.
template <int dim>
void gather_new_velocities(const problem::Model<dim>& model, BodyGrid<dim>& grid);

/// Update stress first: the nodal velocities at a time `ahead` (s) after the beginning of the step, v + ahead a, with the
/// supports.
template <int dim>
void predict_velocities(const problem::Model<dim>& model, Real ahead, BodyGrid<dim>& grid);

/// The divergence of a nodal field in a cell with particles, with its part around an axis, 1/s of m/s.
template <int dim>
Real divergence(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& field);

/// The volume change sum V div(v) dt of each cell, for the projection.
template <int dim>
void sum_volume_changes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

}  // namespace berm::mpm
