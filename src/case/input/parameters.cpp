// SPDX-License-Identifier: BSD-3-Clause
#include "input/catalogue.hpp"

#include "input/message_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::input {
namespace {

using Row = std::vector<std::string>;

/// Rows of one table that exist under the same condition.
struct Group {
  std::string condition;  ///< `law = "mohr_coulomb"`; "" = always
  std::vector<Row> rows;  ///< key, kind, unit, values, default, meaning
};

struct Section {
  std::string heading, meaning;
  std::vector<Group> groups;
};

std::string condition_of(const Listed& entry)
{
  std::string text;
  for (const Condition& condition : entry.conditions)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", condition.selector, in_quotes(condition.word));
  return text;
}

Row row_of(const Listed& entry)
{
  std::string values = range_text(entry.range, entry.unit);
  if (const std::string usual = range_text(entry.usual, entry.unit); !usual.empty())
    values += fmt::format("{}usual: {}", values.empty() ? "" : "; ", usual);
  for (const std::string& word : entry.words) values += (values.empty() ? "" : ", ") + in_quotes(word);
  return {entry.key, type_words(entry), entry.unit, values, entry.required ? "required" : entry.default_text, entry.meaning};
}

void collect(const Listed& table, const std::string& path, const std::string& heading, std::vector<Section>& sections)
{
  Section section{heading, table.meaning + (table.required ? " (required)" : ""), {}};
  for (const Listed& entry : table.children) {
    if (entry.kind != Listed::Kind::value && entry.kind != Listed::Kind::word) continue;
    const std::string condition = condition_of(entry);
    auto group = std::find_if(section.groups.begin(), section.groups.end(), [&](const Group& g) { return g.condition == condition; });
    if (group == section.groups.end()) group = section.groups.insert(group, {condition, {}});
    group->rows.push_back(row_of(entry));
  }
  if (!section.groups.empty()) sections.push_back(section);
  for (const Listed& entry : table.children) {
    const std::string inner = path.empty() ? entry.key : path + "." + entry.key, condition = condition_of(entry);
    const std::string with = condition.empty() ? "" : fmt::format(", with {}", condition);
    if (entry.kind == Listed::Kind::table) collect(entry, inner, fmt::format("[{}]{}", inner, with), sections);
    if (entry.kind == Listed::Kind::named_tables) collect(entry, inner + ".NAME", fmt::format("[{}.NAME]{}", inner, with), sections);
    if (entry.kind == Listed::Kind::array) collect(entry, inner, fmt::format("[[{}]]{}", inner, with), sections);
  }
}

std::vector<Section> sections(const Listed& of_case, const std::vector<OtherInput>& others)
{
  std::vector<Section> all;
  collect(of_case, "", "The case", all);
  for (const OtherInput& other : others) collect(other.keys, "", other.heading, all);
  return all;
}

/// Characters, not bytes, of a UTF-8 text.
int width_of(const std::string& text)
{
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A text within a table of Markdown.
std::string cell(const std::string& text)
{
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string parameter_table(const Listed& of_case, const std::vector<OtherInput>& others)
{
  std::string text = "Numbers are in SI units (angles in radians), or texts with any unit of the same dimension: \"20 mm\", \"35 deg\".\n";
  for (const Section& section : sections(of_case, others)) {
    text += fmt::format("\n{}{}{}\n", section.heading, section.meaning.empty() ? "" : "   ", section.meaning);
    std::vector<int> widths(6);
    for (const Group& group : section.groups)
      for (const Row& row : group.rows)
        for (int k = 0; k < 6; ++k) widths[k] = std::max(widths[k], width_of(row[k]));
    for (const Group& group : section.groups) {
      if (!group.condition.empty()) text += fmt::format("  with {}:\n", group.condition);
      for (const Row& row : group.rows) {
        std::string line = " ";
        for (int k = 0; k < 6; ++k)
          if (widths[k] > 0) line += fmt::format(" {}{:{}}", row[k], "", widths[k] - width_of(row[k]) + 1);
        text += fmt::format("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
      }
    }
  }
  return text;
}

std::string parameter_page(const Listed& of_case, const std::vector<OtherInput>& others)
{
  std::string text =
      "# Parameters\n\n"
      "This page is written by `berm params --markdown`; change a parameter where it is declared, in `src/`, and write the page again.\n\n"
      "A case is a TOML file. A number is in SI units, angles in radians, or a text with any unit of the same dimension that UDUNITS-2\n"
      "knows: `\"20 mm\"`, `\"35 deg\"`, `\"-50 gravity\"`. `NAME` stands for a name of your choice. Where a default is empty, the key is "
      "not set.\n"
      "Every key can be changed from the command line by its path, `--set material.NAME.KEY=VALUE`; a stage is given by its name,\n"
      "`--set stage.NAME.until.time=VALUE`. Quantities in N/m, kg/m and the like are per metre run in plane strain; around an axis and in "
      "space they "
      "are in N,\n"
      "kg and the like.\n";
  for (const Section& section : sections(of_case, others)) {
    const bool is_table = section.heading.starts_with("[");
    const std::size_t end = section.heading.find_last_of(']');
    const std::string heading =
        is_table ? fmt::format("`{}`{}", section.heading.substr(0, end + 1), section.heading.substr(end + 1)) : section.heading;
    text += fmt::format("\n## {}\n", heading);
    if (!section.meaning.empty()) text += fmt::format("\n{}\n", cell(section.meaning));
    for (const Group& group : section.groups) {
      if (!group.condition.empty()) text += fmt::format("\nWith `{}`:\n", group.condition);
      text += "\n| key | kind | unit | values | default | meaning |\n|---|---|---|---|---|---|\n";
      for (const Row& row : group.rows) {
        text += fmt::format("| `{}` |", row[0]);
        for (int k = 1; k < 6; ++k) text += row[k].empty() ? " |" : fmt::format(" {} |", cell(row[k]));
        text += "\n";
      }
    }
  }
  return text;
}

}  // namespace berm::input
