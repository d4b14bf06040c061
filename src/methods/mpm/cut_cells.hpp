// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Finds what the rigid bodies that touch body b leave of the cells which their surfaces cut, and how full that is: the filled fraction of a node counts over what is left of the
/// cells around it, so that cells beside a rigid body are within the soil and not at a free surface. A node of which less than a quarter is left does not judge (1), and
/// a cell without particles counts as empty only where more than half of it is left. Follows from the rigid bodies' poses alone. No effect on bodies without cut cells.
template <int dim>
void find_cut_cells(const problem::Model<dim>& model, const problem::State<dim>& state, Index b, BodyGrid<dim>& grid);

}  // namespace berm::mpm
