// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Cells that are larger than at the start by more than cells of one size differ: this many times.
constexpr Real coarser_cells = 1.6;

/// The largest cell of the mesh at the lower half of a rigid body's surface, where its shape is: the side of the square (cube) whose half (sixth) is as large, m.
/// NaN of a half-plane, and where none of the surface is in the mesh. `start` is where the search begins, and the cell that it found last.
template <int dim>
Real cell_size_at(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Index& start);

}  // namespace berm::problem
