// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/measured_test.cpp
#include "soil_fit/laboratory_ags.hpp"

#include "input/text_table.hpp"
#include "os/error.hpp"
#include "site/ags_groups.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_fit {
namespace {

using site::AgsGroup;

/// What AGS knows a specimen by.
std::string specimen_of(const AgsGroup& group, const site::Row& row)
{
  std::string key;
  for (const char* heading : {"LOCA_ID", "SAMP_TOP", "SAMP_REF", "SAMP_TYPE", "SAMP_ID", "SPEC_REF", "SPEC_DPTH"})
    key += group.of(row, heading) + "/";
  return key;
}

/// "BH1/3.50/2": hole, depth and stage of a triaxial test.
std::string name_of(const AgsGroup& group, const site::Row& row)
{
  const std::string depth = group.of(row, "SPEC_DPTH");
  std::string name = group.of(row, "LOCA_ID") + "/" + (depth.empty() ? group.of(row, "SAMP_TOP") : depth);
  for (const char* heading : {"SPEC_REF", "TRET_TESN"})
    if (const std::string part = group.of(row, heading); !part.empty()) name += "/" + part;
  return name;
}

std::string unit_of(const AgsGroup& group, const std::string& heading)
{
  const std::size_t place = group.place_of(heading);
  return place < group.units.size() ? group.units[place] : "";
}

std::vector<const AgsGroup*> groups_named(const std::vector<AgsGroup>& groups, const std::string& name, const std::string& file)
{
  std::vector<const AgsGroup*> found;
  for (const AgsGroup& group : groups)
    if (group.name == name) found.push_back(&group);
  if (found.empty()) throw InputError(fmt::format("{}: has no group {}", file, name));
  for (const AgsGroup* group : found)
    if (group->units != found[0]->units || group->headings != found[0]->headings)
      throw InputError(
          fmt::format("{}:{}: this group {} has other headings or units than that of line {}", file, group->line, name, found[0]->line));
  return found;
}

Sheet increments(const std::vector<AgsGroup>& groups, const std::string& file)
{
  const auto all = groups_named(groups, "CONS", file);
  Sheet sheet{{"test", fmt::format("vertical_stress ({})", unit_of(*all[0], "CONS_INCF")), "void_ratio"}, {}, {}};
  for (const AgsGroup* group : all)
    for (const site::Row& row : group->rows) {
      sheet.fields.push_back({name_of(*group, row), group->of(row, "CONS_INCF"), group->of(row, "CONS_INCE")});
      sheet.lines.push_back(row.line);
    }
  return sheet;
}

/// Whether TREG says that a specimen was sheared otherwise.
bool is_other_test(const std::vector<AgsGroup>& groups, const std::string& specimen, bool drained)
{
  for (const AgsGroup& group : groups)
    for (const site::Row& row : group.rows)
      if (group.name == "TREG" && specimen_of(group, row) == specimen)
        if (const std::string type = group.of(row, "TREG_TYPE"); type.size() >= 2 && type[0] == 'C') return (type[1] == 'D') != drained;
  return false;
}

Sheet failures(const std::vector<AgsGroup>& groups, bool drained, const std::string& file)
{
  const auto all = groups_named(groups, "TRET", file);
  const auto with_unit = [&](const char* word, const char* heading) { return fmt::format("{} ({})", word, unit_of(*all[0], heading)); };
  Sheet sheet{{"test", with_unit("axial_strain", "TRET_STRN"), with_unit("q", "TRET_DEVF")}, {}, {}};
  if (drained)
    sheet.headings.insert(sheet.headings.end(), {with_unit("lateral_stress", "TRET_CONP"), with_unit("volumetric_strain", "TRET_STV")});
  else
    sheet.headings.insert(sheet.headings.end(), {with_unit("lateral_stress", "TRET_CONP"), with_unit("excess_pore_pressure", "TRET_PWPF")});
  for (const AgsGroup* group : all)
    for (const site::Row& row : group->rows) {
      if (is_other_test(groups, specimen_of(*group, row), drained)) continue;
      const auto of = [&](const char* heading) { return group->of(row, heading); };
      std::string rise;
      if (const auto start = input::number_in(of("TRET_PWPI")), end = input::number_in(of("TRET_PWPF")); start && end)
        rise = fmt::format("{}", *end - *start);
      sheet.fields.push_back({name_of(*group, row), "0", "0", of("TRET_CONP"), "0"});
      sheet.fields.push_back({name_of(*group, row), of("TRET_STRN"), of("TRET_DEVF"), of("TRET_CONP"), drained ? of("TRET_STV") : rise});
      sheet.lines.insert(sheet.lines.end(), 2, row.line);
    }
  if (sheet.fields.empty())
    throw InputError(
        fmt::format("{}: the group TRET has no {} test (TREG_TYPE {})", file, drained ? "drained" : "undrained", drained ? "CD" : "CU"));
  return sheet;
}

}  // namespace

Sheet sheet_of_ags(const std::string& file, const std::string& text, const MeasuredKind& kind)
{
  const std::vector<AgsGroup> groups = site::read_ags_groups(file, text);
  if (std::holds_alternative<element::Oedometer>(kind)) return increments(groups, file);
  if (const auto* triaxial = std::get_if<element::Triaxial>(&kind)) return failures(groups, triaxial->drained, file);
  throw InputError(fmt::format("{}: AGS has oedometer and triaxial tests of those that are fitted, not {}", file, word_of(kind)));
}

}  // namespace berm::soil_fit
