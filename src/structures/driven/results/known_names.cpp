// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/results/known_names_test.cpp
#include "structures/driven/results/known_names.hpp"

#include "structures/driven/results/details.hpp"
#include "structures/driven/results/results.hpp"
#include "structures/driven/results/states.hpp"

#include <regex>

namespace berm::driven {
namespace {

/// A drag that has all that a drag may have.
DragResults whole_drag(const Stage& stage, Real D)
{
  DragResults drag{.stage = stage.name};
  drag.points = {{D, D, 1, 1}};
  drag.largest = drag.breakout = DragPeak{D, 1};
  drag.end = DragPoint{D, D, 1, 1};
  for (std::optional<Real>* number : {&drag.residual, &drag.berm, &drag.V, &drag.over_penetration, &drag.H_noise, &drag.V_rms_error,
                                      &drag.berm_height, &drag.berm_distance, &drag.remoulded_depth, &drag.remoulded_area})
    *number = 1;
  if (stage.by_force) drag.moved = Displacements{.time_half_D = 1, .time_D = 1};
  return drag;
}

/// A run that has all that one of these stages may have.
Results whole_results(const Stages& stages, Real D)
{
  Results all;
  all.push = {{D, 1}};
  all.push_end = PushPoint{D, 1};
  all.travel = {{D, 1}};
  for (std::optional<Real>* number : {&all.V_noise, &all.second_impulse_over_V, &all.overlap_max, &all.gap_mean}) *number = 1;
  for (const char* state : state_names) all.states.push_back({state, D, 1});
  for (const Stage& stage : stages) {
    if (stage.kind == problem::StageKind::drag) all.drags.push_back(whole_drag(stage, D));
    if (stage.kind == problem::StageKind::push) all.other_pushes.push_back({stage.name, D, 1});
    if (stage.upwards) all.uplifts.push_back({.stage = stage.name, .end = DragPoint{D, D, 1, 1}});
  }
  return all;
}

}  // namespace

std::string without_number(const std::string& name)
{
  static const std::regex number("_[0-9.]+D(?=_|$)");
  return std::regex_replace(name, number, "_#D");
}

std::vector<std::string> known_names(const problem::Case& c)
{
  const base::BodyScale scale = base::body_scale(c);
  if (!(scale.width > 0)) return {};
  std::vector<std::string> names;
  for (const run_folder::Quantity& q : quantities_of(whole_results(stages_of(c), scale.width), scale))
    names.push_back(without_number(q.name));
  if (c.geometry == problem::Geometry::space)
    for (const char* axis : {"Mx", "My", "Mz"})
      for (const char* end : {"_end_of_push", "_end_of_drag"}) names.push_back(std::string(axis) + end);
  for (const problem::StageSettings& stage : c.stage)
    for (const char* begin : {"U_of_", "t50_of_", "T50_of_"}) names.push_back(without_number(begin + stage.name));
  for (const std::string& detail : detail_names()) names.push_back(detail);
  return names;
}

}  // namespace berm::driven
