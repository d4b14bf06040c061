// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm::mesh {

/// Patches as rings: for each cell the next of its patch, ascending, and after the last the first. A cell alone is followed by itself.
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

/// Groups the cells into patches that do not overlap: `rounds` times each group is joined with a neighbouring one of the same region, those with
/// the fewest free neighbours first; a group that finds no free neighbour goes to the smallest neighbouring group. So patches have about 2^rounds
/// cells. Triangles around a node where two straight lines cross stay alone: they do not lock.
template <int dim>
Patches make_patches(const Mesh<dim>& mesh, int rounds);

}  // namespace berm::mesh
