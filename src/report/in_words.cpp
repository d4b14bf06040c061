// SPDX-License-Identifier: BSD-3-Clause
#include "report/in_words.hpp"

#include "report/pipe_soil.hpp"
#include "report/resistance.hpp"
#include "report/run_points.hpp"

#include <fmt/format.h>

namespace berm {
namespace {

constexpr Real same_depth = 0.005;  // of D

std::string subject_of(const Case& c)
{
  return !is_circle(c) ? "the body" : modelled_part(c) < 1 ? "the half of the pipe that is modelled" : "the pipe";
}

/// What the vertical direction does in the first drag.
std::string vertical_words(const Case& c)
{
  for (const StageSettings& stage : c.stage) {
    if (stage.kind != StageKind::drag) continue;
    if (stage.vertical_velocity) return " while it is driven vertically, too";
    return stage.vertical == Vertical::fixed ? " with w fixed" : " with V held";
  }
  return "";
}

std::string push_words(const RunRecord& run, const RunPoints& points, const Shown& shown)
{
  const PushPoint& end = *points.push_end;
  const std::string begin = is_wished_in_place(run)
                                ? fmt::format("Wished in place at w = {} and pushed to w = {} D", shown.length_said(run, points.first_w),
                                              said_number(end.w / run.scale.diameter))
                                : fmt::format("Pushed to w = {}", shown.length_said(run, end.w));
  return fmt::format("{}, {} carries V = {}. ", begin, subject_of(run.settings), shown.force_said(run, end.V));
}

std::string drag_words(const RunRecord& run, const RunPoints& points, const Shown& shown)
{
  const DragPoint& last = points.drag.back();
  const Real D = run.scale.diameter, began = points.push_end ? points.push_end->w : points.first_w;
  const std::string travel = said_number(last.u / D), vertical = vertical_words(run.settings);
  const std::string subject = subject_of(run.settings);
  std::string words;
  if (points.push_end)
    words = fmt::format("Dragged {} D{}, it", travel, vertical);
  else if (is_wished_in_place(run))
    words =
        fmt::format("Wished in place at w = {} and dragged {} D{}, {}", shown.length_said(run, points.first_w), travel, vertical, subject);
  else
    words = fmt::format("Dragged {} D{}, {}", travel, vertical, subject);
  words += fmt::format(" meets H = {}, {} V", shown.force_said(run, last.H), said_number(last.H / last.V));
  if (std::abs(last.w - began) > same_depth * D)
    words += fmt::format(", and {} to w = {}", last.w > began ? "sinks" : "rises", shown.length_said(run, last.w));
  return words + ". ";
}

std::string resistance_words(const RunRecord& run, const Shown& shown)
{
  const Resistance resistance = resistance_of(run);
  if (std::isnan(resistance.last_change)) return "";
  if (!resistance.breakout) return fmt::format("There is {}.", no_peak_words(resistance));
  const std::string peak = fmt::format("H peaks at u = {} with {}", shown.length_said(run, resistance.breakout->u),
                                       shown.force_said(run, resistance.breakout->H));
  return resistance.residual ? fmt::format("{}, then comes to {}.", peak, shown.force_said(run, *resistance.residual))
                             : fmt::format("{}, and still changes at the end of the drag.", peak);
}

}  // namespace

std::string results_in_words(const RunRecord& run, const Shown& shown)
{
  const RunPoints points = points_of(run);
  if (!points.push_end && points.drag.empty())
    return "Nothing is known of its forces: it did not come as far as a push, or as 0.1 D of a drag.";
  std::string words;
  if (points.push_end) words += push_words(run, points, shown);
  if (!points.drag.empty()) words += drag_words(run, points, shown) + resistance_words(run, shown);
  return words;
}

}  // namespace berm
