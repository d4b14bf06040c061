// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/known_names_test.cpp
#include "structures/driven/known_names.hpp"

#include "structures/base/support_reactions.hpp"
#include "structures/driven/details.hpp"
#include "structures/driven/results.hpp"
#include "structures/driven/states.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

namespace berm::driven {
namespace {

using problem::StageRole;

/// A drag that has all that a drag of this stage may have: a force that is given has no peak and no plateau, and one that varies no resistance.
DragResults whole_drag(const Stage& stage, Real D)
{
  DragResults drag{.stage = stage.name};
  drag.end = DragPoint{D, D, 1, 1};
  for (std::optional<Real>* number : {&drag.V, &drag.berm_height, &drag.berm_distance, &drag.remoulded_depth, &drag.remoulded_area})
    *number = 1;
  if (stage.holds_V) drag.V_rms_error = 1;
  if (stage.by_force) drag.moved = Displacements{.time_half_D = 1, .time_D = 1};
  if (stage.varies) {
    drag.moved->time_scale = 1;
    return drag;
  }
  for (const Real point : drag_points) drag.points.push_back({point * D, D, 1, 1});
  drag.largest = DragPeak{D, 1};
  drag.over_penetration = drag.H_noise = 1;
  if (stage.by_force) return drag;
  drag.breakout = DragPeak{D, 1};
  drag.onset = drag.residual = drag.berm = 1;
  return drag;
}

/// All that a way down may have.
void take_whole_push(Results& all, Real D)
{
  all.push = {{D, 1}};
  all.push_end = PushPoint{D, 1};
  for (const Real point : travel_points) all.travel.push_back({point * D, 1});
  all.V_noise = all.second_impulse_over_V = 1;
}

/// Whether a run of these stages may come to a state.
bool may_come_to(const std::string& state, const problem::Case& c, const Stages& stages)
{
  const auto said = [&](StageRole role) {
    return std::any_of(c.stage.begin(), c.stage.end(), [&](const problem::StageSettings& stage) { return stage.role == role; });
  };
  if (state == "flooded") return said(StageRole::flooded);
  if (state == "emptied") return said(StageRole::emptied);
  if (state == "laid")
    return said(StageRole::lay) || std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.lays; });
  return true;
}

/// A run that has all that one of these stages may have.
Results whole_results(const problem::Case& c, const Stages& stages, Real D)
{
  Results all;
  all.overlap_max = all.gap_mean = 1;
  for (const char* state : state_names)
    if (may_come_to(state, c, stages)) all.states.push_back({state, D, 1});
  for (const Stage& stage : stages) {
    const bool dragged = !all.drags.empty();
    if (stage.kind == problem::StageKind::drag) {
      all.drags.push_back(whole_drag(stage, D));
      continue;
    }
    if (!dragged && !stage.upwards && !all.push_end) take_whole_push(all, D);
    if (dragged || stage.upwards || stage.force) all.other_pushes.push_back({stage.name, D, 1});
    if (stage.upwards) all.uplifts.push_back({.stage = stage.name, .end = DragPoint{D, D, 1, 1}});
  }
  return all;
}

}  // namespace

std::string without_number(const std::string& name)
{
  static const std::regex with_number("V_at_w_([0-9.]{1,20})D(_over_gammaD2)?");
  std::smatch parts;
  if (!std::regex_match(name, parts, with_number)) return name;
  const std::string digits = parts.str(1);
  Real read = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), read);
  const Real number = std::round(read / push_spacing) * push_spacing;
  const bool is_taken = number > 0 && name == name_at("V_at_w", number) + parts.str(2);
  return is_taken ? "V_at_w_#D" + parts.str(2) : name;
}

std::vector<std::string> known_names(const problem::Case& c)
{
  const base::BodyScale scale = base::body_scale(c);
  if (!(scale.width > 0)) return {};
  std::vector<std::string> names;
  for (const run_folder::Quantity& q : quantities_of(whole_results(c, stages_of(c), scale.width), scale))
    names.push_back(without_number(q.name));
  if (c.geometry == problem::Geometry::space)
    for (const char* axis : {"Mx", "My", "Mz"})
      for (const char* end : {"_end_of_push", "_end_of_drag"}) names.push_back(std::string(axis) + end);
  for (const problem::StageSettings& stage : c.stage)
    for (const char* begin : {"U_of_", "t50_of_", "T50_of_"}) names.push_back(begin + stage.name);
  for (const std::string& name : base::support_quantity_names(c)) names.push_back(name);
  for (const std::string& detail : detail_names()) names.push_back(detail);
  return names;
}

}  // namespace berm::driven
