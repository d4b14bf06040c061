// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Step 1: scales V and V sigma of the cells so that a cell within the body stands for its own volume |c|, and not for the sum of the volumes of the
/// particles that are in it by chance: kappa_c sum V_p = (1 - zeta) sum V_p + zeta |c|. zeta goes smoothly from 0 to 1 as the least filled of the cell's nodes
/// goes from 0.75 to 0.9 (the part of the cells around the node that particles fill, 0 where one of them has no particle), so that the cells at a free
/// surface keep what their particles have. Strain and force take the same weights, so they stay conjugate. Does nothing where the body is not
/// integrated so.
template <int dim>
void integrate_full_cells(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

}  // namespace berm::mpm
