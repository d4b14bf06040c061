// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// AGS 4: lines of texts between quotation marks. A group has the lines GROUP, HEADING, UNIT, TYPE and one DATA for each row. SCPT holds the readings, SCPG what a
// sounding has once.
#include "core/error.hpp"
#include "input/message_text.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace berm::site {
namespace {

const std::map<std::string, Reading> headings = {{"SCPT_DPTH", Reading::depth},
                                                 {"SCPT_RES", Reading::q_c},
                                                 {"SCPT_QT", Reading::q_t},
                                                 {"SCPT_FRES", Reading::f_s},
                                                 {"SCPT_PWP2", Reading::u_2}};

/// A group of the file: its headings, their units, and its rows of data, without the first word of each line.
struct Group {
  int line = 0;
  std::vector<std::string> headings, units;
  std::vector<Row> rows;

  std::size_t place_of(const std::string& heading) const
  {
    return static_cast<std::size_t>(std::find(headings.begin(), headings.end(), heading) - headings.begin());
  }
  /// "" where there is no such heading.
  std::string of(const Row& row, const std::string& heading) const
  {
    const std::size_t place = place_of(heading);
    return place < headings.size() ? row.fields[place] : "";
  }
};

std::map<std::string, Group> read_groups(const std::string& file, const std::string& text)
{
  std::map<std::string, Group> groups;
  Group* group = nullptr;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::vector<std::string> fields = fields_of(line, ',');
    const std::string word = fields[0];
    if (word.empty() && fields.size() == 1) continue;
    fields.erase(fields.begin());
    if (word == "GROUP" && !fields.empty()) {
      group = &groups[fields[0]];
      group->line = number;
      continue;
    }
    if (!group)
      throw InputError(fmt::format("{}begins with {}: a file of AGS 4 begins with \"GROUP\"", at(file, number), input::in_quotes(word)));
    if (word == "HEADING")
      group->headings = fields;
    else if (word != "UNIT" && word != "TYPE" && word != "DATA")
      throw InputError(fmt::format("{}{} is none of GROUP, HEADING, UNIT, TYPE and DATA", at(file, number), input::in_quotes(word)));
    else if (fields.size() != group->headings.size())
      throw InputError(fmt::format("{}has {} values, and the group {} headings", at(file, number), fields.size(), group->headings.size()));
    else if (word == "UNIT")
      group->units = fields;
    else if (word == "DATA")
      group->rows.push_back({number, fields});
  }
  return groups;
}

std::string name_of(const Group& group, const Row& row)
{
  const std::string test = group.of(row, "SCPG_TESN");
  return group.of(row, "LOCA_ID") + (test.empty() ? "" : "/" + test);
}

}  // namespace

Table read_ags(const std::string& file, const std::string& text, const std::string& location)
{
  std::map<std::string, Group> groups = read_groups(file, text);
  if (groups.find("SCPT") == groups.end()) throw InputError(fmt::format("{}: has no group SCPT, which holds the readings of a cone", file));
  const Group& readings = groups["SCPT"];
  if (readings.units.empty()) throw InputError(fmt::format("{}the group SCPT has no line UNIT", at(file, readings.line)));
  std::vector<std::string> names;
  for (const Row& row : readings.rows)
    if (const std::string name = name_of(readings, row); std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  if (location.empty() && names.size() > 1)
    throw InputError(fmt::format("{}: has {} soundings: name one with --location ({})", file, names.size(), input::listed(names)));
  const std::string wanted = location.empty() && !names.empty() ? names[0] : location;
  if (std::find(names.begin(), names.end(), wanted) == names.end())
    throw InputError(fmt::format("{}: has no sounding {}{}", file, input::in_quotes(wanted), input::suggestion(wanted, names)));

  Table table;
  table.file = file;
  for (std::size_t i = 0; i < readings.headings.size(); ++i) {
    const auto known = headings.find(readings.headings[i]);
    table.columns.push_back(
        {known == headings.end() ? Reading::other : known->second, readings.headings[i], readings.units[i], readings.line + 2});
  }
  for (const Row& row : readings.rows)
    if (name_of(readings, row) == wanted) table.rows.push_back(row);
  for (const Row& row : groups["SCPG"].rows)
    if (const std::string ratio = groups["SCPG"].of(row, "SCPG_CAR"); name_of(groups["SCPG"], row) == wanted && !ratio.empty())
      table.area_ratio = area_ratio_of(ratio, file, row.line, "SCPG_CAR");
  return table;
}

}  // namespace berm::site
