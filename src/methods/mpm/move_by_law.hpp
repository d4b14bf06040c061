// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_test.cpp
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The laws of a body as its law sees them.
template <class Law>
struct SoilOf {
  const std::vector<const void*>&laws, &laws_without_dilation;  ///< as BodyLaws has them
  const CellField<Index>& first_of_cell;
  const std::vector<VolumeRule>& rules;  ///< by material
  bool dilates;                          ///< the first material
  bool local_strength;                   ///< particles keep strength, stiffness or material for themselves
  int material_index_offset;             ///< of the material's number among a particle's extra numbers, or none
  static constexpr int local_size = material::local_size<Law>(), first_local = Law::state_size;  ///< its strength and stiffness there

  /// Where the laws of a cell begin in the lists.
  Index first_in(Index cell) const { return !first_of_cell.empty() ? first_of_cell[cell] : 0; }
  const Law& law(Index number) const { return *static_cast<const Law*>(laws[static_cast<std::size_t>(number)]); }
  const Law& law_without_dilation(Index number) const
  {
    return *static_cast<const Law*>(laws_without_dilation[static_cast<std::size_t>(number)]);
  }
};

/// Steps 5 and 9-11 of the paper for particles of one law, which move for the time `motion` (s). Compiled in a file of its own for each law (move_law.cpp.in).
template <int dim, class Law>
void move_by_law(const SoilOf<Law>& soil, Real motion, const problem::Model<dim>& model, problem::State<dim>& state,
                 Workspace<dim>& workspace, Index body);

}  // namespace berm::mpm
