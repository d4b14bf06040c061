// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The viscous mean stress of the cells of a body that can yield, eta h div(v) with the means of h and div(v), before the step,
/// over the cells of the patch. Computed once a step, because forces and the work on the particles use the same.
template <int dim>
void find_viscous_stress(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Step 1, equation 2: the internal force of each cell on its corners, -sum V sigma grad N. With the volumetric projection
/// the cell's mean stress is replaced by the volume average over its patch, the same average that the strain gets, so that
/// strain and force stay conjugate. The viscous mean stress is added.
template <int dim>
void spread_internal_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

/// The divergence of a nodal field in a cell with particles, with its part around an axis, 1/s of m/s.
template <int dim>
Real divergence(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& field);

/// The volume change sum V div(v) dt of each cell, for the projection.
template <int dim>
void sum_volume_changes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

}  // namespace berm::mpm
