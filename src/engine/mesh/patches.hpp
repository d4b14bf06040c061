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

/// Cells per patch, such that a mesh has as many conditions on the volume (one a patch) as nodes: a node within a mesh of triangles lies in six of them, which
/// is two cells a node; in a mesh of tetrahedra it lies in 22 to 24, which is about six.
template <int dim>
constexpr int patch_cells = dim == 2 ? 2 : 6;

/// The patches that the mesh names where it does and `cells` are the usual number; else groups the cells into disjoint patches of about `cells` that are joined by faces and lie in one region. A patch grows from the cell with the fewest
/// free neighbours, each time by the neighbour that shares most corners with its cells, then by that with the fewest free neighbours. Where it does not
/// grow to more than half of `cells`, each of its cells joins the smallest neighbouring patch. Triangles around a node where two straight lines cross stay
/// single: they do not lock.
template <int dim>
Patches make_patches(const Mesh<dim>& mesh, int cells = patch_cells<dim>);

}  // namespace berm::mesh
