// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/internal_forces_test.cpp
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The cells of a patch that hold particles, ascending.
struct PatchCells {
  std::array<Index, mesh::max_patch_cells> cell;
  int count = 0;

  const Index* begin() const { return cell.data(); }
  const Index* end() const { return cell.data() + count; }
};

/// Calls visit(patch) once for each patch with an active cell of this rank: what cells of a patch share is worked out once. visit may write only data of the
/// patch's active cells.
template <int dim, class Visit>
void for_each_patch(const char* label, const mesh::Patches& patches, const bodies::Particles<dim>& particles, const BodyGrid<dim>& grid,
                    const Visit& visit)
{
  const auto& active = particles.active();
  for_each(label, particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    // The ring ascends from the patch's first cell. The first active one of it visits the patch.
    Index first = patches[cell];
    while (first > cell) first = patches[first];
    for (Index before = first; before < cell; before = patches[before])
      if (particles.is_active(before)) return;
    PatchCells patch;
    Index member = first;
    do {
      if (grid.moments[member].any()) patch.cell[patch.count++] = member;
      member = patches[member];
    } while (member != first);
    visit(patch);
  });
}

}  // namespace berm::mpm
