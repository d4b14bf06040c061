// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/known_names_test.cpp
#include "structures/driven/known_names.hpp"

#include "structures/base/support_reactions.hpp"
#include "structures/driven/answers.hpp"
#include "structures/driven/details.hpp"
#include "structures/driven/states.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>
#include <span>

namespace berm::driven {
namespace {

using settings::StageRole;

/// Whether a run of these stages may come to a state.
bool may_come_to(const std::string& state, const settings::Case& c, const Stages& stages)
{
  const auto said = [&](StageRole role) {
    return std::any_of(c.stage.begin(), c.stage.end(), [&](const settings::StageSettings& stage) { return stage.role == role; });
  };
  if (state == "flooded") return said(StageRole::flooded);
  if (state == "emptied") return said(StageRole::emptied);
  if (state == "laid")
    return said(StageRole::lay) || std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.lays; });
  return true;
}

/// Names of rows at multiples of D.
template <class Rows>
void add_names_at(base::AnswerList& list, const Rows& rows, std::span<const Real> parts)
{
  for (const Real part : parts) list.at(part), list.add_names(rows, Stage{});
  list.at({});
}

}  // namespace

std::string without_number(const std::string& name)
{
  static const std::regex with_number("([A-Za-z0-9_.-]*\\.)?V_at_w_([0-9.]{1,20})D(_over_gammaD2)?");
  std::smatch parts;
  if (!std::regex_match(name, parts, with_number)) return name;
  const std::string digits = parts.str(2);
  Real read = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), read);
  const Real number = std::round(read / push_spacing) * push_spacing;
  const bool is_taken = number > 0 && name == parts.str(1) + name_at("V_at_w", number) + parts.str(3);
  return is_taken ? parts.str(1) + "V_at_w_#D" + parts.str(3) : name;
}

std::vector<std::string> known_names(const settings::Case& c)
{
  const base::BodyScale scale = base::body_scale(c);
  if (!(scale.width > 0)) return {};
  const Stages stages = stages_of(c);
  base::AnswerList list(scale.dimension);
  list.twins(scale.unit_weight * scale.width * scale.width, scale.width);
  bool dragged = false, went_down = false;
  for (const Stage& stage : stages) {
    const std::string prefix = stage.name + ".";
    if (stage.kind == settings::StageKind::drag) {
      list.of(stage.name, dragged ? prefix : "");
      if (resists(stage)) add_names_at(list, point_answers, drag_points);
      list.add_names(drag_answers, stage);
      dragged = true;
      continue;
    }
    if (!dragged && !stage.upwards && !went_down) {
      went_down = true;
      list.of("push", "");
      add_names_at(list, depth_answers, {&push_spacing, 1});  // one stands for all: without_number
      list.add_names(push_answers, stage);
      add_names_at(list, travel_answers, travel_points);
    }
    list.of(stage.name, prefix);
    if (dragged || stage.upwards || stage.force) list.add_names(other_push_answers, stage);
    if (stage.upwards) list.add_names(uplift_answers, stage);
  }
  for (const char* state : state_names)
    if (may_come_to(state, c, stages)) list.of(state, std::string(state) + "."), list.add_names(state_answers, Stage{});
  list.of("", "");
  for (const auto& row : run_answers)
    if (went_down || std::string_view(row.name) != "second_impulse_over_V") list.add(row.name, row.unit, nan, row.meaning);
  std::vector<std::string> names = list.names();
  for (std::string& name : names) name = without_number(name);
  if (c.geometry == settings::Geometry::space)
    for (const char* axis : {"Mx", "My", "Mz"})
      for (const char* end : {"_end_of_push", "_end_of_drag"}) names.push_back(std::string(axis) + end);
  for (const settings::StageSettings& stage : c.stage)
    for (const char* begin : {"U_of_", "t50_of_", "T50_of_"}) names.push_back(begin + stage.name);
  for (const std::string& name : base::support_quantity_names(c)) names.push_back(name);
  for (const std::string& detail : detail_names()) names.push_back(detail);
  return names;
}

}  // namespace berm::driven
