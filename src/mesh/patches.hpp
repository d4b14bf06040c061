// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm::mesh {

/// Patches as circular lists: for each cell the next of its patch, ascending, and after the last the first. A single cell is
/// followed by itself.
using Patches = CellField<Index>;
constexpr int max_patch_cells = 16;

/// Calls visit(cell) for each cell of the patch that `first` belongs to, beginning with it.
template <class Visit>
[[gnu::always_inline]] inline void for_each_in_patch(const Patches& patches, Index first, const Visit& visit)
{
  Index cell = first;
  do {
    visit(cell);
    cell = patches[cell];
  } while (cell != first);
}

/// Groups the cells into disjoint patches of about 2^rounds cells: in each of the `rounds` every group is joined with a
/// neighbour in the same region, those with the fewest free neighbours first; a group without a free neighbour joins the
/// smallest neighbouring group. Triangles around a node where two straight lines cross stay single: they do not lock.
template <int dim>
Patches make_patches(const Mesh<dim>& mesh, int rounds);

}  // namespace berm::mesh
