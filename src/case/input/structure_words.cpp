// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "input/structure_words.hpp"

#include "input/message_text.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::input {
namespace {

std::vector<std::string> allowed_words()
{
  std::vector<std::string> words = {"automatic"};
  for (const StructureWord& structure : structure_words()) words.emplace_back(structure.word);
  return words;
}

Listed& child(Listed& table, const std::string& key)
{
  return *std::ranges::find(table.children, key, &Listed::key);
}

}  // namespace

const std::vector<StructureWord>& structure_words()
{
  using enum StructureGeometry;
#define BERM_WORD(word, geometry) {#word, geometry},
#define BERM_WORD_OF_ROOM(room, word, geometry) BERM_WORD(word, geometry)
  static const std::vector<StructureWord> words = {BERM_STRUCTURES(BERM_WORD, BERM_WORD, BERM_WORD_OF_ROOM)};
#undef BERM_WORD_OF_ROOM
#undef BERM_WORD
  return words;
}

void check_structures(const settings::Case& c)
{
  for (const auto& [name, rigid] : c.rigid) {
    const std::string& word = rigid.structure;
    const auto refuse = [&, &of = name](const std::string& why, const std::vector<std::string>& allowed) {
      throw KeyError(fmt::format("rigid.{}.structure: {}{}", of, why, suggestion(word, allowed)));
    };
    if (word == "automatic") continue;
    const auto found = std::ranges::find_if(structure_words(), [&](const StructureWord& one) { return one.word == word; });
    if (found == structure_words().end()) refuse(fmt::format("{} is not one of its words", in_quotes(word)), allowed_words());
    const bool in_plane = c.geometry == settings::Geometry::plane_strain;
    if (found->geometry == StructureGeometry::round && in_plane)
      refuse("is round: it needs geometry = \"axisymmetric\" or \"space\"; in plane strain a body is a bar or a strip",
             {"t_bar", "footing", "pipe"});
    if (found->geometry == StructureGeometry::plane && !in_plane)
      refuse("is loaded normal to its axis: it needs geometry = \"plane_strain\"", {"ball", "pipe"});
  }
}

Listed case_catalogue()
{
  Listed all = catalogue_of<settings::Case>();
  Listed& structure = child(child(all, "rigid"), "structure");
  structure.kind = Listed::Kind::word;
  structure.words = allowed_words();
  structure.default_text = structure.words.front();
  structure.default_value = structure.default_text;
  return all;
}

}  // namespace berm::input
