// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// A sounding in AGS 4: the group SCPT holds the readings, SCPG what a sounding has once.
#include "input/message_text.hpp"
#include "os/error.hpp"
#include "site/ags_groups.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace berm::site {
namespace {

const std::map<std::string, Reading> headings = {{"SCPT_DPTH", Reading::depth},
                                                 {"SCPT_RES", Reading::q_c},
                                                 {"SCPT_QT", Reading::q_t},
                                                 {"SCPT_FRES", Reading::f_s},
                                                 {"SCPT_PWP2", Reading::u_2}};

std::string name_of(const AgsGroup& group, const Row& row)
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
AgsGroup readings_of(const std::vector<AgsGroup>& groups, const std::string& wanted, const std::string& file)
{
  AgsGroup found;
  for (const AgsGroup& group : groups) {
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

std::optional<Real> area_ratio_in(const std::vector<AgsGroup>& groups, const std::string& wanted, const std::string& file)
{
  std::optional<Real> found;
  for (const AgsGroup& group : groups)
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
  const std::vector<AgsGroup> groups = read_ags_groups(file, text);
  std::vector<std::string> names;
  bool has_readings = false;
  for (const AgsGroup& group : groups) {
    if (group.name != "SCPT") continue;
    has_readings = true;
    for (const Row& row : group.rows)
      if (const std::string name = name_of(group, row); std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (!has_readings) throw InputError(fmt::format("{}: has no group SCPT, which holds the readings of a cone", file));
  const std::string wanted = wanted_of(names, location, file);
  const AgsGroup readings = readings_of(groups, wanted, file);
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
