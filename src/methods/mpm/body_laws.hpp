// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_local_strength_test.cpp
#pragma once

#include "material/laws.hpp"
#include "mpm/grid.hpp"

namespace berm::mpm {

/// The prepared laws of a body, which all are of one type, and what its particles keep of their own. Cells that are as large but for a hundredth are of one class;
/// the laws of a class come together, one for each material.
struct BodyLaws {
  std::vector<material::PreparedMaterial> prepared;      ///< what the following point to
  std::vector<const void*> laws, laws_without_dilation;  ///< the second for particles at their maximum volume
  CellField<Index> first_of_cell;                        ///< of the laws of the cell's class; empty: all cells are of one
  std::vector<VolumeRule> volume_rules;                  ///< by material
  bool dilates;                                          ///< the first material
  bool local_strength;                                   ///< particles differ in strength, stiffness or material
  int material_index_offset;                             ///< of the material's number among the extra numbers of a particle, or none
};

}  // namespace berm::mpm
