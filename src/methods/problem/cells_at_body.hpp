// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Cells that are larger than at the start by more than cells of one size differ: this many times.
constexpr Real coarser_cells = 1.5;

/// The largest cell of the mesh at the lower half of a rigid body's surface, where its shape is: the side of the square (cube) whose half (sixth) is as large, m. The surface of a tall body more than half its width above the bed is left out.
/// NaN of a half-plane, and where none of the surface is in the mesh. `start` is where the search begins, and the cell that it found last.
template <int dim>
Real cell_size_at(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Index& start);

/// The name of the region of the mesh at a point; "" where there is none.
template <int dim>
std::string region_at(const Model<dim>& model, const Vec<dim>& x);

/// The name of the region of the mesh just below the lowest point of a rigid body with an embedment of `depth` (m), at its place along the bed at the start;
/// "" where the body has no end or there is no soil's mesh.
template <int dim>
std::string region_below(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Real depth);

}  // namespace berm::problem
