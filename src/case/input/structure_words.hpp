// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/catalogue.hpp"
#include "settings/case.hpp"

namespace berm::input {

/// The geometries that a structure can be in: all, all but plane strain, or plane strain alone.
enum class StructureGeometry { any, round, plane };

/// All structures, one a row, in the order in which they are tried: PENETROMETER and SHAFT (word, geometry), STRUCTURE (room, word, geometry). Each is a function named after
/// its word: what is pushed down, or pushed down and loaded sideways, a penetration::Penetrometer of penetration or lateral; any other a base::Structure of its room.
#define BERM_STRUCTURES(PENETROMETER, SHAFT, STRUCTURE)                                                                                    \
  PENETROMETER(cone, round)                                                                                                                \
  PENETROMETER(ball, round)                                                                                                                \
  PENETROMETER(t_bar, plane)                                                                                                               \
  SHAFT(pile, round)                                                                                                                       \
  SHAFT(skirt, round)                                                                                                                      \
  PENETROMETER(footing, any)                                                                                                               \
  STRUCTURE(anchor, anchor, any)                                                                                                           \
  STRUCTURE(line, pipeline, plane)                                                                                                         \
  STRUCTURE(pipe, pipe, any)                                                                                                               \
  STRUCTURE(generic, other, any)

/// A value of rigid.NAME.structure.
struct StructureWord {
  const char* word;
  StructureGeometry geometry;
};

/// All but "automatic".
const std::vector<StructureWord>& structure_words();

/// Throws KeyError where rigid.NAME.structure is none of the words, or one that the geometry of the case cannot have.
void check_structures(const settings::Case& c);

/// All parameters of a case.
Listed case_catalogue();

}  // namespace berm::input
