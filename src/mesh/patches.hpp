// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm {

/// The cells of the patch that a cell belongs to, itself among them, ascending; the rest none.
constexpr int most_patch_cells = 16;
using Patch = std::array<Index, most_patch_cells>;

/// Groups the cells into patches that do not overlap: `rounds` times each group is joined with a neighbouring one of the same region, those with
/// the fewest free neighbours first; a group that finds no free neighbour goes to the smallest neighbouring group. So patches have about 2^rounds
/// cells.
template <int dim>
CellField<Patch> make_patches(const Mesh<dim>& mesh, int rounds);

}  // namespace berm
