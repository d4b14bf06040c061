// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/soils_test.cpp
#pragma once

#include "start/kinds.hpp"

namespace berm::start {

/// A soil that publications describe.
struct Soil {
  std::string name;      ///< as `--soil` takes it
  std::string material;  ///< "clay" or "sand": it stands for the [material.clay] or [material.sand] of a template
  std::string title;     ///< what it is, in a line
  std::string source;    ///< where the numbers are from
  std::string trust;     ///< how far they reach
  std::string keys;      ///< of the material, with its law
};

/// All of them: clays, then sands.
const std::vector<Soil>& soils();

/// Names of those that a kind takes: a kind with a material of that name does.
std::vector<std::string> soils_for(const Kind& kind);

/// A case with a soil instead of its material of the same name. Throws InputError where there is no such soil, or the kind does not take it.
std::string with_soil(const Kind& kind, const std::string& text, const std::string& soil);

/// Where a material's table stands in the text of a case: from its [material.NAME] to the blank line that ends it; both npos where there is none.
struct Table {
  std::size_t begin = std::string::npos, end = std::string::npos;
};
Table table_of(const std::string& text, const std::string& material);

}  // namespace berm::start
