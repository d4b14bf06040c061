// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/pipe/report/in_words.hpp"

#include "structures/pipe/published/pipe_soil.hpp"
#include "structures/pipe/results/resistance.hpp"
#include "structures/pipe/results/run_points.hpp"
#include "text/shown_number.hpp"
#include "text/tex_math.hpp"

#include <fmt/format.h>

namespace berm::pipe {
namespace {

constexpr Real same_depth = 0.005;  // of D

std::string subject_of(const problem::Case& c)
{
  return fmt::format("{}{}", modelled_part(c) < 1 ? "the half that is modelled of the " : "the ", text::html_text(base::body_word(c)));
}

/// What the vertical direction does in the first drag.
std::string vertical_words(const problem::Case& c)
{
  for (const problem::StageSettings& stage : c.stage) {
    if (stage.kind != problem::StageKind::drag) continue;
    if (stage.vertical_velocity) return " while it is driven vertically, too";
    return stage.vertical == problem::Vertical::fixed ? " with w fixed" : " with V held";
  }
  return "";
}

std::string push_words(const PipeRun& run, const RunPoints& points, const base::DisplayUnits& shown)
{
  const PushPoint& end = *points.push_end;
  const StageEnd stage = end_of_push(run);
  const std::string begin = starts_embedded(run)
                                ? fmt::format("Wished in place at w = {} and pushed to w = {} D",
                                              shown.length_text(run.scale, points.first_w), text::short_number(end.w / run.scale.width))
                                : fmt::format("Pushed to w = {}", shown.length_text(run.scale, end.w));
  return fmt::format("{}{}, {} carries V = {}. ", begin, stage.reached ? "" : ", " + stage.at, subject_of(run.settings),
                     shown.force_text(run.scale, end.V));
}

/// "Dragged 1 D with V held, the pipe meets", after a push "it".
std::string drag_begin(const PipeRun& run, const RunPoints& points, const std::string& travel, const base::DisplayUnits& shown)
{
  const std::string vertical = vertical_words(run.settings), subject = points.push_end ? "it" : subject_of(run.settings);
  const std::string begin = !points.push_end && starts_embedded(run)
                                ? fmt::format("Wished in place at w = {} and dragged", shown.length_text(run.scale, points.first_w))
                                : std::string("Dragged");
  return fmt::format("{} {}{}, {} meets", begin, travel, vertical, subject);
}

std::string drag_words(const PipeRun& run, const RunPoints& points, const base::DisplayUnits& shown)
{
  const DragPoint& last = points.drag.back();
  const Real D = run.scale.width, began = points.push_end ? points.push_end->w : points.first_w;
  std::string words = fmt::format("{} H = {}, {} V", drag_begin(run, points, text::short_number(last.u / D) + " D", shown),
                                  shown.force_text(run.scale, last.H), text::short_number(last.H / last.V));
  if (std::abs(last.w - began) > same_depth * D)
    words += fmt::format(", and {} to w = {}", last.w > began ? "sinks" : "rises", shown.length_text(run.scale, last.w));
  return words + ". ";
}

/// Of a drag that came to none of its points.
std::string short_drag_words(const PipeRun& run, const RunPoints& points, const Resistance& resistance, const base::DisplayUnits& shown)
{
  const Real D = run.scale.width;
  const std::string travel = std::isnan(resistance.travel) ? "less than 0.1 D" : text::short_number(resistance.travel / D) + " D";
  const std::string V =
      std::isnan(resistance.V_at_largest) ? "" : fmt::format(", under V = {}", shown.force_text(run.scale, resistance.V_at_largest));
  return fmt::format("{} at most H = {}, at u = {}{}. ", drag_begin(run, points, travel, shown),
                     shown.force_text(run.scale, resistance.largest->H), shown.length_text(run.scale, resistance.largest->u), V);
}

std::string resistance_words(const PipeRun& run, const Resistance& resistance, const base::DisplayUnits& shown)
{
  if (std::isnan(resistance.last_change)) return "";
  const StageEnd end = end_of_drag(run);
  if (!resistance.breakout) return fmt::format("There is {}.", no_peak_words(resistance, end.to));
  const std::string peak = fmt::format("H peaks at u = {} with {}", shown.length_text(run.scale, resistance.breakout->u),
                                       shown.force_text(run.scale, resistance.breakout->H));
  return resistance.residual ? fmt::format("{}, then comes to {}.", peak, shown.force_text(run.scale, *resistance.residual))
                             : fmt::format("{}, and still changes {}.", peak, end.reached ? "at the " + end.at : end.at);
}

}  // namespace

std::string results_in_words(const PipeRun& run, const base::DisplayUnits& shown)
{
  const RunPoints points = points_of(run);
  const Resistance resistance = resistance_of(run);
  if (!points.push_end && !resistance.largest) return "Nothing is known of its forces: it did not come as far as a push or a drag.";
  std::string words;
  if (points.push_end) words += push_words(run, points, shown);
  if (resistance.largest) {
    words += points.drag.empty() ? short_drag_words(run, points, resistance, shown) : drag_words(run, points, shown);
    words += resistance_words(run, resistance, shown);
  }
  words.erase(words.find_last_not_of(' ') + 1);
  if (!is_circle(run.settings)) words += fmt::format(" D is the width of the {}.", text::html_text(base::body_word(run.settings)));
  return words;
}

}  // namespace berm::pipe
