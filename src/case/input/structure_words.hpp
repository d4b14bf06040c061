// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/catalogue.hpp"
#include "settings/case.hpp"

namespace berm::input {

/// The geometries that a structure can be in: all, all but plane strain, or plane strain alone.
enum class StructureGeometry { any, round, plane };

/// A value of rigid.NAME.structure.
struct StructureWord {
  const char* word;
  StructureGeometry geometry = StructureGeometry::any;
};

/// All but "automatic".
const std::vector<StructureWord>& structure_words();

/// Throws KeyError where rigid.NAME.structure is none of the words, or one that the geometry of the case cannot have.
void check_structures(const settings::Case& c);

/// All parameters of a case.
Listed case_catalogue();

}  // namespace berm::input
