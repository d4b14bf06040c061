// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_local_strength_test.cpp
#pragma once

#include "material/laws.hpp"
#include "mpm/grid.hpp"

namespace berm::mpm {

/// The prepared laws of a body, which all are of one type, and what its particles keep of their own.
struct BodyLaws {
  std::vector<material::PreparedMaterial> laws, laws_without_dilation;  ///< by material; the second for particles at their maximum volume
  std::vector<VolumeRule> volume_rules;                                 ///< by material
  bool dilates;                                                         ///< the first material
  bool local_strength;                                                  ///< particles differ in strength, stiffness or material
  int material_index_offset;  ///< of the material's number among the extra numbers of a particle, or none
};

}  // namespace berm::mpm
