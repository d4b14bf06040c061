// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// AGS 4: lines of texts between quotation marks. A group has the lines GROUP, HEADING, UNIT, TYPE and one DATA for each row. SCPT holds the readings, SCPG what a
// sounding has once. A group may come several times in files that were put together, each time with headings and units of its own.
#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/error.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <array>
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

constexpr std::array<std::string_view, 5> words = {"GROUP", "HEADING", "UNIT", "TYPE", "DATA"};

/// A group of the file, once: its headings, their units, and its rows of data, without the first word of each line.
struct Group {
  std::string name;
  int line = 0, line_of_units = 0;
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

bool begins_line(const std::string& line)
{
  const std::string word = input::fields_of(line, ',')[0];
  return line.starts_with('"') && std::find(words.begin(), words.end(), word) != words.end();
}

/// Takes the next line, with those that go on with its last text; `number` becomes that of the first.
bool next_line(std::istringstream& lines, int& number, int& taken, const std::string& file, std::string& line)
{
  if (!std::getline(lines, line)) return false;
  number = ++taken;
  while (!input::closes_its_quotes(line)) {
    std::string more;
    if (!std::getline(lines, more) || begins_line(more)) throw InputError(at(file, number) + "a quotation mark is not closed");
    ++taken;
    line += ' ' + more;
  }
  return true;
}

void take(Group& group, const std::string& word, const std::vector<std::string>& fields, const std::string& file, int line)
{
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw InputError(fmt::format("{}{} is none of GROUP, HEADING, UNIT, TYPE and DATA", at(file, line), input::in_quotes(word)));
  if ((word == "HEADING" && !group.headings.empty()) || (word == "UNIT" && !group.units.empty()))
    throw InputError(
        fmt::format("{}a second line {} in the group {}: a line GROUP is missing before it", at(file, line), word, group.name));
  if (word == "HEADING") {
    group.headings = fields;
    return;
  }
  if (fields.size() != group.headings.size())
    throw InputError(fmt::format("{}has {} values, and the group {} headings", at(file, line), fields.size(), group.headings.size()));
  if (word == "UNIT") {
    group.units = fields;
    group.line_of_units = line;
  } else if (word == "DATA") {
    group.rows.push_back({line, fields});
  }
}

std::vector<Group> read_groups(const std::string& file, const std::string& text)
{
  std::vector<Group> groups;
  std::istringstream lines(text);
  int number = 0, taken = 0;
  for (std::string line; next_line(lines, number, taken, file, line);) {
    std::vector<std::string> fields = input::fields_of(line, ',');
    const std::string word = fields[0];
    if (word.empty() && fields.size() == 1) continue;
    fields.erase(fields.begin());
    if (groups.empty() && word.starts_with("**"))
      throw InputError(at(file, number) + "is of AGS 3, which has other groups and units: have it exported as AGS 4");
    if (word == "GROUP" && !fields.empty())
      groups.push_back({fields[0], number, number, {}, {}, {}});
    else if (groups.empty())
      throw InputError(fmt::format("{}begins with {}: a file of AGS 4 begins with \"GROUP\"", at(file, number), input::in_quotes(word)));
    else
      take(groups.back(), word, fields, file, number);
  }
  return groups;
}

std::string name_of(const Group& group, const Row& row)
{
  const std::string test = group.of(row, "SCPG_TESN");
  return group.of(row, "LOCA_ID") + (test.empty() ? "" : "/" + test);
}

/// The sounding that is meant: by its full name, or by its location where that has one.
std::string wanted_of(const std::vector<std::string>& names, const std::string& location, const std::string& file)
{
  if (names.empty()) throw InputError(fmt::format("{}: the group SCPT has no line DATA", file));
  if (location.empty() && names.size() > 1)
    throw InputError(fmt::format("{}: has {} soundings: name one with --location ({})", file, names.size(), input::listed(names)));
  if (location.empty() || std::find(names.begin(), names.end(), location) != names.end()) return location.empty() ? names[0] : location;
  std::vector<std::string> tests;
  for (const std::string& name : names)
    if (name.starts_with(location + "/")) tests.push_back(name);
  if (tests.size() == 1) return tests[0];
  if (!tests.empty())
    throw InputError(fmt::format("{}: --location {} has {} tests: name one ({})", file, location, tests.size(), input::listed(tests)));
  throw InputError(fmt::format("{}: has no sounding {}{}", file, input::in_quotes(location), input::suggestion(location, names)));
}

/// The readings of a sounding, of all groups SCPT that have some: these have the same headings and units.
Group readings_of(const std::vector<Group>& groups, const std::string& wanted, const std::string& file)
{
  Group found;
  for (const Group& group : groups) {
    if (group.name != "SCPT") continue;
    std::vector<Row> rows;
    for (const Row& row : group.rows)
      if (name_of(group, row) == wanted) rows.push_back(row);
    if (rows.empty()) continue;
    if (!found.rows.empty() && (found.headings != group.headings || found.units != group.units))
      throw InputError(fmt::format("{}{} has readings in this group SCPT and in that of line {}, with other headings or units: leave one",
                                   at(file, group.line), wanted, found.line));
    rows.insert(rows.begin(), found.rows.begin(), found.rows.end());
    found = group;
    found.rows = rows;
  }
  if (found.units.empty()) throw InputError(fmt::format("{}the group SCPT has no line UNIT", at(file, found.line)));
  return found;
}

std::optional<Real> area_ratio_in(const std::vector<Group>& groups, const std::string& wanted, const std::string& file)
{
  std::optional<Real> found;
  for (const Group& group : groups)
    for (const Row& row : group.rows) {
      if (group.name != "SCPG" || name_of(group, row) != wanted) continue;
      const std::optional<Real> ratio = area_ratio_of(group.of(row, "SCPG_CAR"), file, row.line, "SCPG_CAR");
      if (found && ratio && *found != *ratio)
        throw InputError(
            fmt::format("{}SCPG_CAR: {} has the area ratio {:g} here and {:g} before", at(file, row.line), wanted, *ratio, *found));
      if (ratio) found = ratio;
    }
  return found;
}

}  // namespace

Table read_ags(const std::string& file, const std::string& text, const std::string& location)
{
  const std::vector<Group> groups = read_groups(file, text);
  std::vector<std::string> names;
  bool has_readings = false;
  for (const Group& group : groups) {
    if (group.name != "SCPT") continue;
    has_readings = true;
    for (const Row& row : group.rows)
      if (const std::string name = name_of(group, row); std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (!has_readings) throw InputError(fmt::format("{}: has no group SCPT, which holds the readings of a cone", file));
  const std::string wanted = wanted_of(names, location, file);
  const Group readings = readings_of(groups, wanted, file);
  Table table;
  table.file = file;
  for (std::size_t i = 0; i < readings.headings.size(); ++i) {
    const auto known = headings.find(readings.headings[i]);
    table.columns.push_back(
        {known == headings.end() ? Reading::other : known->second, readings.headings[i], readings.units[i], readings.line_of_units, ""});
  }
  table.rows = readings.rows;
  table.area_ratio = area_ratio_in(groups, wanted, file);
  return table;
}

}  // namespace berm::site
