// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/in_words_test.cpp, tests/unit/report/results/results_section_test.cpp
#include "structures/driven/report.hpp"

#include "settings/time_scale.hpp"
#include "structures/base/soil_words.hpp"
#include "structures/driven/displacements.hpp"
#include "structures/driven/resistance.hpp"
#include "structures/driven/run_points.hpp"
#include "structures/driven/states.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ranges>

namespace berm::driven {
namespace {

constexpr Real same_depth = 0.005;  // of D

std::string subject_of(const settings::Case& c)
{
  return fmt::format("{}{}", base::modelled_part(c) < 1 ? "the half that is modelled of the " : "the ",
                     text::html_text(base::body_word(c)));
}

/// What the vertical direction does in a drag: " with V held, 0.9 kN/m on average".
std::string vertical_words(const DrivenRun& run, const DragResults& drag, const base::DisplayUnits& shown)
{
  const auto stage = std::find_if(run.settings.stage.begin(), run.settings.stage.end(),
                                  [&](const settings::StageSettings& s) { return s.name == drag.stage; });
  if (stage == run.settings.stage.end()) return "";
  const std::string V = drag.V ? shown.force_text(run.scale, *drag.V) : "";
  if (stage->vertical_velocity) return " while it is driven vertically, too";
  if (stage->vertical == settings::Vertical::fixed)
    return V.empty() ? " with w fixed" : fmt::format(" with w fixed, under V = {} on average", V);
  return V.empty() ? " with V held" : fmt::format(" with V held, {} on average", V);
}

std::string push_words(const DrivenRun& run, const RunPoints& points, const base::DisplayUnits& shown)
{
  const PushPoint& end = *points.push_end;
  const StageEnd stage = end_of_push(run);
  const std::string begin = starts_embedded(run)
                                ? fmt::format("Wished in place at w = {} and pushed to w = {} D",
                                              shown.length_text(run.scale, points.first_w), text::short_number(end.w / run.scale.width))
                                : fmt::format("Pushed to w = {}", shown.length_text(run.scale, end.w));
  return fmt::format("{}{}, {} carries V = {}{}. ", begin, stage.reached ? "" : ", " + stage.at, subject_of(run.settings),
                     shown.force_text(run.scale, end.V), converged_words(run, "V_end_of_push", shown));
}

/// What happens to V and w in the pushes before the main drag, or after that.
std::string other_push_words(const DrivenRun& run, const Results& results, bool before, const base::DisplayUnits& shown)
{
  const std::string& main = results.main_drag().stage;
  const auto main_stage = std::ranges::find(run.stages, main, &Stage::name);
  std::string words;
  for (const OtherPushResults& push : results.other_pushes) {
    const bool is_before = std::any_of(run.stages.begin(), main_stage, [&](const Stage& stage) { return stage.name == push.stage; });
    const bool lifts = std::ranges::find(results.uplifts, push.stage, &UpliftResults::stage) != results.uplifts.end();
    if (is_before == before && !lifts)
      words += fmt::format("After \"{}\" V = {} at w = {}. ", text::html_text(push.stage), shown.force_text(run.scale, push.V),
                           shown.length_text(run.scale, push.w));
  }
  return words;
}

/// How it was laid, and how it lies in operation.
std::string states_words(const DrivenRun& run, const Results& results, const base::DisplayUnits& shown)
{
  std::string words;
  for (const StateResults& state : results.states) {
    if (state.name != "laid" && state.name != "operation") continue;
    const auto drags = std::ranges::count_if(run.stages, &Stage::lays);
    words += state.name == "operation" ? std::string("In operation it")
             : drags == 0              ? std::string("Laid, it")
                                       : fmt::format("Laid, by {} {}, it", drags, drags == 1 ? "drag" : "drags");
    words +=
        fmt::format(" lies at w = {}{}{}. ", shown.length_text(run.scale, state.w),
                    state.V < 0 ? ", and the soil pushes it down with " : " under V = ", shown.force_text(run.scale, std::abs(state.V)));
  }
  return words;
}

/// What else the displacement under a load history depends on.
std::string inertia_words(const DrivenRun& run, const DragResults& drag)
{
  const auto stage = std::ranges::find(run.stages, drag.stage, &Stage::name);
  const Index rigid = main_rigid(run.settings);
  if (stage == run.stages.end() || !stage->varies || rigid == none) return "";
  return fmt::format("That is for its mass of {} {} and for {}: a force beyond the resistance accelerates it. ",
                     text::short_number(run.settings.rigid[rigid].second.mass), run.scale.dimension == 2 ? "kg/m" : "kg",
                     settings::time_scale_words(stage->asked));
}

/// How far a force moves it: what is asked of a pipe on the bed in a storm.
std::string moved_words(const DrivenRun& run, const DragResults& drag, const base::DisplayUnits& shown)
{
  const Displacements& moved = *drag.moved;
  const auto length = [&](Real metres) { return shown.length_text(run.scale, std::abs(metres)); };
  std::string words = fmt::format("Under the force of \"{}\" {} moves {} at most, with a residual displacement of {}; its embedment is w = "
                                  "{} at most and w = {} at the end. ",
                                  text::html_text(drag.stage), subject_of(run.settings), length(moved.u_largest), length(moved.u_end),
                                  length(moved.w_largest), length(moved.w_end));
  if (moved.half_cycles > 1)
    words += fmt::format("Its largest half-cycle is {}, of {}. ", length(moved.largest_half_cycle), text::count_words(moved.half_cycles));
  if (moved.time_scale) words += inertia_words(run, drag);
  const auto after = [&](Real time) { return "after " + text::time_words(time) + (moved.time_scale ? " of the record" : ""); };
  if (moved.time_D)
    return words + fmt::format("Breakout: the displacement exceeds 0.5 D {} and 1 D {}. ", after(*moved.time_half_D), after(*moved.time_D));
  if (moved.time_half_D)
    return words + fmt::format("Breakout: the displacement exceeds 0.5 D {}; 1 D is not reached. ", after(*moved.time_half_D));
  return words + "It stays within 0.5 D. ";
}

/// How far the water had drained when a lift began: in the last stage before it that has a degree of consolidation.
std::string drained_words(const DrivenRun& run, const UpliftResults& uplift)
{
  std::string words;
  const std::vector<base::Dissipation> rests = base::dissipation_of(run.record);
  for (const settings::StageSettings& stage : run.settings.stage) {
    if (stage.name == uplift.stage) return words;
    const auto rest = std::ranges::find(rests, stage.name, &base::Dissipation::stage);
    if (rest != rests.end())
      words = fmt::format(", when {} of the excess pore pressure of \"{}\" has dissipated,", text::percent_words(rest->degree),
                          text::html_text(stage.name));
  }
  return "";
}

/// Whether a buried body stays: what has to pull it for that.
std::string stays_words(const DrivenRun& run, const UpliftResults& uplift, const base::DisplayUnits& shown)
{
  if (!base::circle_of(run.settings) || uplift.w_begin <= run.scale.width) return "";
  return fmt::format("Available uplift resistance, excluding the submerged weight: {}. ", shown.force_text(run.scale, uplift.largest.H));
}

std::string uplift_words(const DrivenRun& run, const UpliftResults& uplift, const base::DisplayUnits& shown)
{
  const std::string drained = drained_words(run, uplift), stays = stays_words(run, uplift, shown);
  std::string words =
      fmt::format("Lifted from w = {} in \"{}\"{} {} mobilises an uplift resistance of {} after {}",
                  shown.length_text(run.scale, uplift.w_begin), text::html_text(uplift.stage), drained.empty() ? "," : drained,
                  subject_of(run.settings), shown.force_text(run.scale, uplift.largest.H), shown.length_text(run.scale, uplift.largest.u));
  if (!uplift.falls()) {
    const bool at_end = uplift.end && uplift.end->u - uplift.largest.u < residual_travel(uplift.end->u, run.scale);
    return words + (at_end ? ", still growing at the end of the lift. " : ", and keeps it to the end. ") + stays;
  }
  if (uplift.end)
    words += fmt::format(", and {} at the end, after {}", shown.force_text(run.scale, uplift.end->H),
                         shown.length_text(run.scale, uplift.end->u));
  return words + ". " + stays;
}

/// Of the main drag on a slope: what the soil holds the body by along its ground when it begins to slide, and what its weight does.
///
///   T = H cos(b) - V sin(b), N = V cos(b) + H sin(b), with b the angle by which the ground rises in the direction of the drag.
std::string slope_words(const DrivenRun& run, const Resistance& resistance, const base::DisplayUnits& shown)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&run.settings.mesh);
  if (bed == nullptr || bed->slope == 0 || bed->trench || bed->step) return "";
  const DragResults drag = run.results().main_drag();
  const auto stage = std::ranges::find(run.stages, drag.stage, &Stage::name);
  const std::optional<Real> H = resistance.breakout ? std::optional(resistance.breakout->H) : resistance.onset;
  if (stage == run.stages.end() || !drag.V || !H) return "";
  const Real angle = stage->direction * bed->slope, V = *drag.V;
  const Real T = *H * std::cos(angle) - V * std::sin(angle), N = V * std::cos(angle) + *H * std::sin(angle);
  const std::string degrees = text::short_number(std::abs(angle) / degree) + "°";
  const Real by_weight = std::abs(std::tan(angle));
  return fmt::format(
      "Along the ground, which {} by {} along its path, the soil resistance is T = {} when it {} (H cos {} {} V sin {}): {} times "
      "the force N = {} on the ground. Its weight alone pulls it down the slope with {} times N, {}. ",
      angle > 0 ? "rises" : "falls", degrees, shown.force_text(run.scale, T), resistance.breakout ? "breaks out" : "begins to slide",
      degrees, angle > 0 ? "−" : "+", degrees, text::short_number(T / N), shown.force_text(run.scale, N), text::short_number(by_weight),
      T > by_weight * N ? "less than that: it stays" : "more than that: it slides");
}

/// The state in which the main drag begins; empty where that is not known.
std::optional<State> begin_of_drag(const DrivenRun& run)
{
  const States states = states_of(run.record);
  const State* after = find_state(states, "after_" + run.results().main_drag().stage);
  if (after == nullptr || after == &states.front()) return {};
  return *(after - 1);
}

/// " after "sweep_2", from w = 93 mm," where another drag came before the main one in the same state of the pipe's life.
std::string earlier_drag_words(const DrivenRun& run, const base::DisplayUnits& shown)
{
  constexpr std::string_view after = "after_";
  const std::optional<State> begin = begin_of_drag(run);
  if (!begin || !begin->name.starts_with(after)) return "";
  return fmt::format(" after \"{}\", from w = {},", text::html_text(begin->name.substr(after.size())),
                     shown.length_text(run.scale, begin->w));
}

/// "Dragged 1 D with V held, 0.8 kN/m on average, the pipe mobilises", after a push "it".
std::string drag_begin(const DrivenRun& run, const RunPoints& points, const std::string& travel, const base::DisplayUnits& shown)
{
  const Results results = run.results();
  const DragResults& drag = results.main_drag();
  const std::string vertical = vertical_words(run, drag, shown), subject = points.push_end ? "it" : subject_of(run.settings),
                    which = (results.prefix_of(drag).empty() ? "" : fmt::format(" in \"{}\"", text::html_text(drag.stage))) +
                            earlier_drag_words(run, shown);
  const std::string begin = !points.push_end && starts_embedded(run)
                                ? fmt::format("Wished in place at w = {} and dragged", shown.length_text(run.scale, points.first_w))
                                : std::string("Dragged");
  return fmt::format("{}{} {}{}, {} mobilises", begin, which, travel, vertical, subject);
}

/// Of the main drag, to its very end.
std::string drag_words(const DrivenRun& run, const RunPoints& points, const DragPoint& end, const base::DisplayUnits& shown)
{
  const Results results = run.results();
  const std::optional<State> begin = begin_of_drag(run);
  const Real D = run.scale.width, began = begin ? begin->w : points.push_end ? points.push_end->w : points.first_w;
  std::string words =
      fmt::format("{} H = {}{}, {} V, over the last {} D", drag_begin(run, points, text::short_number(end.u / D) + " D", shown),
                  shown.force_text(run.scale, end.H), converged_words(run, results.prefix_of(results.main_drag()) + "H_end_of_drag", shown),
                  text::short_number(end.H / end.V), text::short_number(residual_travel(end.u, run.scale) / D));
  if (std::abs(end.w - began) > same_depth * D)
    words += fmt::format(", and {} to w = {}", end.w > began ? "sinks" : "rises", shown.length_text(run.scale, end.w));
  return words + ". ";
}

/// Whether the mean vertical forces of two drags differ by more than noise.
bool is_under_another_V(const DragResults& one, const DragResults& other)
{
  constexpr Real same_V = 0.03;
  return one.V && other.V && std::abs(*one.V - *other.V) > same_V * std::max(std::abs(*one.V), std::abs(*other.V));
}

/// Of drags under different vertical forces: " H = 1 kN/m under V = 2 kN/m, H = ...".
std::string each_in_words(const DrivenRun& run, const Results& results, const base::DisplayUnits& shown)
{
  constexpr std::size_t max = 4;
  std::string words;
  std::size_t count = 0;
  for (std::size_t k = results.main + 1; k < results.drags.size(); ++k) {
    const DragResults& drag = results.drags[k];
    if (!drag.end || drag.moved) continue;
    if (count == max) return words + ", and so on (summary.json has them all)";
    words += fmt::format("{} H = {} at the end", count++ == 0 ? "" : ",", shown.force_text(run.scale, drag.end->H));
    if (drag.V) words += fmt::format(" under V = {}", shown.force_text(run.scale, *drag.V));
  }
  return words;
}

/// Of the drags after the main one.
std::string later_drags_words(const DrivenRun& run, const Results& results, const base::DisplayUnits& shown)
{
  Real min = infinity, max = -infinity;
  int later = 0;
  bool other_V = false;
  const DragResults* last = nullptr;
  for (std::size_t k = results.main + 1; k < results.drags.size(); ++k) {
    const DragResults& drag = results.drags[k];
    if (!drag.end || drag.moved) continue;
    min = std::min(min, drag.end->H), max = std::max(max, drag.end->H), ++later;
    other_V = other_V || is_under_another_V(results.main_drag(), drag);
    last = &drag;
  }
  if (later == 0) return "";
  if (later == 1 && other_V)
    return fmt::format(" One more drag follows{}: it mobilises at its end H = {}.", vertical_words(run, *last, shown),
                       shown.force_text(run.scale, min));
  if (other_V) return fmt::format(" {} more drags follow:{}.", later, each_in_words(run, results, shown));
  const std::string range = min == max ? shown.force_text(run.scale, min)
                                       : fmt::format("{} to {}", shown.force_text(run.scale, min), shown.force_text(run.scale, max));
  return fmt::format(" {} {} at {} end H = {}.", later == 1 ? "One more drag follows:" : fmt::format("{} more drags follow:", later),
                     later == 1 ? "it mobilises" : "they mobilise", later == 1 ? "its" : "their", range);
}

/// Of a drag that came to none of its points.
std::string short_drag_words(const DrivenRun& run, const RunPoints& points, const Resistance& resistance, const base::DisplayUnits& shown)
{
  const Real D = run.scale.width;
  const Results results = run.results();
  const std::string prefix = results.prefix_of(results.main_drag());
  const std::string travel = std::isnan(resistance.travel) ? "less than 0.1 D" : text::short_number(resistance.travel / D) + " D";
  return fmt::format("{} at most H = {}{}, at u = {}. ", drag_begin(run, points, travel, shown),
                     shown.force_text(run.scale, resistance.largest->H), converged_words(run, prefix + "H_max", shown),
                     shown.length_text(run.scale, resistance.largest->u));
}

std::string resistance_words(const DrivenRun& run, const Resistance& resistance, const base::DisplayUnits& shown)
{
  if (std::isnan(resistance.last_change)) return "";
  const StageEnd end = end_of_drag(run);
  const Results results = run.results();
  const std::string prefix = results.prefix_of(results.main_drag());
  const auto force = [&](Real value) { return shown.force_text(run.scale, value); };
  const std::string onset = resistance.onset ? fmt::format("It begins to slide at about H = {}. ", force(*resistance.onset)) : "",
                    berm = resistance.berm ? fmt::format("; at its end it meets a berm with {}", force(*resistance.berm)) : "";
  if (!resistance.breakout && resistance.berm)
    return resistance.residual ? fmt::format("{}There is no peak: H is about {} near u = {}{}.", onset, force(*resistance.residual),
                                             shown.length_text(run.scale, *resistance.residual_at), berm)
                               : fmt::format("{}There is neither a peak nor a residual{}.", onset, berm);
  if (!resistance.breakout) return fmt::format("{}There is {}.", onset, no_peak_words(resistance, end.to));
  std::string words = fmt::format("H peaks first at u = {} with {}{}", shown.length_text(run.scale, resistance.breakout->u),
                                  force(resistance.breakout->H), converged_words(run, prefix + "H_breakout", shown));
  const std::string largest =
      resistance.largest && resistance.largest->H > (1 + min_fall) * resistance.breakout->H
          ? fmt::format("{} at u = {}", force(resistance.largest->H), shown.length_text(run.scale, resistance.largest->u))
          : "";
  if (resistance.berm)  // the plateau is before the largest H
    return fmt::format("{}{}{}{}.", words, resistance.residual ? ", then tends to " + force(*resistance.residual) : ", without a residual",
                       berm, largest.empty() ? "" : "; the largest H is " + largest);
  if (!largest.empty()) words += ", grows to " + largest;
  return resistance.residual ? fmt::format("{}, then tends to {}.", words, force(*resistance.residual))
                             : fmt::format("{}, and still changes {}.", words, end.reached ? "at the " + end.at : end.at);
}

}  // namespace

std::string results_in_words(const DrivenRun& run, const base::DisplayUnits& shown, bool push)
{
  const RunPoints points = points_of(run);
  const Resistance resistance = resistance_of(run);
  const Results results = run.results();
  const bool moved = std::ranges::any_of(results.drags, [](const DragResults& drag) { return drag.moved.has_value(); });
  if (!points.push_end && !resistance.largest && results.uplifts.empty() && !moved)
    return "Its forces are not known: the run did not reach a push or a drag.";
  std::string words;
  if (points.push_end && push) words += push_words(run, points, shown);
  words += results.states.empty() ? other_push_words(run, results, true, shown) : states_words(run, results, shown);
  const DragResults& main = results.main_drag();
  if (resistance.largest && !main.moved) {
    words +=
        points.drag.empty() || !main.end ? short_drag_words(run, points, resistance, shown) : drag_words(run, points, *main.end, shown);
    words += resistance_words(run, resistance, shown) + later_drags_words(run, results, shown) + " ";
    words += slope_words(run, resistance, shown);
  }
  for (const DragResults& drag : results.drags)
    if (drag.moved) words += moved_words(run, drag, shown);
  for (std::string doubt : lower_estimates(run.record)) {
    doubt[0] = 'T';
    words += fmt::format("<strong>{}.</strong> ", text::html_text(doubt));
  }
  for (const UpliftResults& uplift : results.uplifts) words += uplift_words(run, uplift, shown);
  words += other_push_words(run, results, false, shown);
  words.erase(words.find_last_not_of(' ') + 1);
  if (!base::circle_of(run.settings)) words += fmt::format(" D is the width of the {}.", text::html_text(base::body_word(run.settings)));
  return words;
}

}  // namespace berm::driven
