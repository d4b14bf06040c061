// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Step 1: scales V and V sigma of the cells so that a cell within the body is integrated over its own volume |c| instead of
/// the sum of the volumes of its particles: kappa_c sum V_p = (1 - zeta) sum V_p + zeta |c|. zeta increases smoothly from 0
/// to 1 as the smallest filled fraction around the cell's nodes (0 where one has no particle) goes from 0.75 to 0.9, so that
/// cells at a free surface keep the volumes of their particles. Strain and force use the same weights and stay conjugate. Where cells are cut by rigid bodies
/// (mpm/cut_cells.hpp) |c| is what is left of a cell. No effect on bodies without full_cells. Where velocities are filtered, each cell also gives its corners
/// the momentum sum m N_k v(x_p) of the nodal velocities, for smooth_velocities, and gets its largest stiffness in a step of dt (s;
/// mpm/small_mass_nodes.hpp), 0 in cells within the body, which have none.
template <int dim>
void prepare_cells(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid);

}  // namespace berm::mpm
