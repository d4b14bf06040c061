// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/quantities.hpp"

#include "record/travel_curve.hpp"
#include "structures/base/display_units.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/driven/displacements.hpp"
#include "structures/driven/path.hpp"
#include "structures/driven/resistance.hpp"
#include "structures/driven/uplift.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::driven {
namespace {

using record::TravelCurve;

constexpr Real in_the_bed = 0.02;  // of D: a pipe that is put on the bed sinks less by its weight
constexpr Real reached = 1e-3;     // of D: a stage that ends at a displacement may stop this much short of it, by rounding and by a step

constexpr Real noise_of_V_from = 0.02, noise_of_H_from = 0.1;  // of D: the forces grow from zero before
constexpr Real widest_spacing = 0.005;                         // of D: rows farther apart tell no noise

/// The standard deviation of a force about its moving mean, over the mean of its magnitude, from a travel on; NaN where there are too few rows for it.
Real noise_of(const std::vector<Real>& travel, const std::vector<Real>& force, Real from, const BodyScale& scale)
{
  if (!scale.noisy) return nan;
  const Real D = scale.width;
  const TravelCurve curve(travel, force);
  if (curve.empty()) return nan;
  const TravelCurve mean = curve.smoothed(base::averaging_half_width * D);
  Real squares = 0, sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < travel.size(); ++k) {
    const Real off = travel[k] >= from ? force[k] - mean.at(travel[k], 0) : nan;
    if (std::isnan(off)) continue;
    squares += off * off;
    sum += std::abs(force[k]);  // a force that changes its direction has a mean near zero
    ++count;
  }
  if (count < 2 || curve.end() - from > (count - 1) * widest_spacing * D) return nan;
  return std::sqrt(squares / count) / (sum / count);
}

std::optional<Real> if_known(Real value)
{
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// A stage ends after the step that reaches its limit.
bool meets(Real value, const std::optional<Real>& limit)
{
  constexpr Real step = 0.01;
  return limit && std::abs(value - *limit) <= step * std::abs(*limit);
}

/// What these pushes give of an end at w.
Prescribed given_by_push(const settings::StageSettings& s, Real w)
{
  Prescribed given;
  given.w = meets(w, s.until.embedment);
  given.V = s.force || !s.loads.of("V").empty() || (s.until.force && !given.w);
  return given;
}

Prescribed given_by_drag(const Stage& stage, Real u)
{
  const settings::StageSettings& s = stage.asked;
  Prescribed given;
  given.u = meets(u, s.until.displacement);
  given.H = stage.by_force;
  given.V_always = s.vertical_force || !s.loads.of("V").empty() || s.water;
  given.w_always = s.vertical == settings::Vertical::fixed && !s.vertical_velocity;
  return given;
}

/// Half of the travel over which V of the push is averaged: in a short one a quarter of its way in the soil at most.
Real half_of_push(const TravelCurve& V, const BodyScale& scale)
{
  return std::min(averaging_half(scale), std::max(Real(0), V.end() - std::max(V.begin(), Real(0))) / 4);
}

void take_push(Results& results, const PushPath& path, const run_folder::History& history, const Stages& stages, const BodyScale& scale)
{
  const Real D = scale.width;
  const TravelCurve V(path.w, path.V);
  if (V.empty()) return;
  const Real half = averaging_half(scale);
  for (int k = 1; k * push_spacing * D <= V.end() + reached * D; ++k)
    if (k * push_spacing * D >= V.begin())
      results.push.push_back({k * push_spacing * D, V.at(std::min(k * push_spacing * D, V.end()), half)});
  results.push_end = PushPoint{V.end(), V_at_end(path, history, stages, scale)};
  results.V_noise = if_known(noise_of(path.w, path.V, std::max(V.begin(), Real(0)) + noise_of_V_from * D, scale));
}

/// V by the travel from the row before the push, of a pipe that is in the bed there.
void take_travel(Results& results, const PushPath& path, const run_folder::History& history, const BodyScale& scale)
{
  const TravelCurve V(path.w, path.V);
  if (V.empty()) return;
  const Real D = scale.width, begin = history["w_m"][std::max(path.rows.front() - 1, 0)];
  if (!(begin >= in_the_bed * D)) return;
  for (const Real point : travel_points)
    if (begin + point * D <= V.end() + reached * point * D)
      results.travel.push_back({point * D, V.at(std::min(begin + point * D, V.end()), std::min(averaging_half(scale), point * D / 4))});
}

/// V of a drag from the row on in which it is what it shall be: mean, and error of what is held.
void take_vertical(DragResults& drag, const DragPath& path, const run_folder::History& history)
{
  const std::vector<Real> force = settled_V(path, history["time_s"]);
  if (force.empty()) return;
  const Real mean = std::accumulate(force.begin(), force.end(), Real{0}) / static_cast<Real>(force.size());
  drag.V = mean;
  if (!path.stage.holds_V) return;
  const Real target = path.stage.held_force.value_or(mean);
  if (target == 0) return;
  Real squares = 0;
  for (const Real f : force) squares += (f - target) * (f - target);
  drag.V_rms_error = std::sqrt(squares / static_cast<Real>(force.size())) / std::abs(target);
}

/// H and V at the end: means over the last tenth of the travel, at least over 0.1 D.
DragPoint end_of(const TravelCurve& H, const TravelCurve& V, const TravelCurve& w, const BodyScale& scale)
{
  const Real travel = H.end() - H.begin(), half = residual_travel(travel, scale) / 2;
  return {H.end(), w.at(w.end(), averaging_half(scale)), H.at(H.end() - half, half), V.at(V.end() - half, half)};
}

/// The end of a drag by a force that varies: forces are means over its last twentieth in time.
DragPoint end_in_time(const DragPath& path, const std::vector<Real>& time)
{
  constexpr Real last_part = 0.05;
  const Real begin = time[path.rows.front()], end = time[path.rows.back()], from = end - last_part * (end - begin);
  DragPoint point{path.travel.back(), path.w.back(), 0, 0};
  int rows = 0;
  for (std::size_t k = 0; k < path.rows.size(); ++k)
    if (time[path.rows[k]] >= from && std::isfinite(path.H[k]) && std::isfinite(path.V[k]))
      point.H += path.H[k], point.V += path.V[k], ++rows;
  point.H /= rows, point.V /= rows;
  return point;
}

DragResults drag_results(const Path& all, std::size_t number, const run_folder::History& history, std::optional<Real> V_max,
                         const BodyScale& scale)
{
  const DragPath& path = all.drags[number];
  DragResults drag{.stage = path.stage.name, .given = given_by_drag(path.stage, path.travel.back())};
  const Real D = scale.width;
  if (path.stage.by_force) drag.moved = displacements_of(path, history, D);
  if (path.stage.varies) {
    take_vertical(drag, path, history);
    drag.end = end_in_time(path, history["time_s"]);
    return drag;
  }
  const TravelCurve H(path.travel, path.H), V(path.travel, path.V), w(path.travel, path.w);
  if (H.empty() || V.empty() || w.empty()) return drag;
  const Real half = averaging_half(scale);
  for (const Real point : drag_points) {
    if (point * D > H.end() + reached * D) break;
    const Real u = std::min(point * D, H.end());
    drag.points.push_back({point * D, w.at(u, half), H.at(u, half), V.at(u, half)});
  }
  drag.H_noise = if_known(noise_of(path.travel, path.H, noise_of_H_from * D, scale));
  const TravelCurve smooth = H.smoothed(half);
  const auto largest = std::max_element(smooth.value().begin(), smooth.value().end());
  drag.largest = DragPeak{smooth.travel()[largest - smooth.value().begin()], *largest};
  take_vertical(drag, path, history);
  if (V_max && drag.V.value_or(0) > 0) drag.over_penetration = *V_max / *drag.V;
  const Resistance resistance = resistance_in(all, number, scale);
  if (std::isnan(resistance.last_change)) return drag;
  drag.end = end_of(H, V, w, scale);
  if (path.stage.by_force) return drag;
  if (resistance.breakout) drag.breakout = DragPeak{resistance.breakout->u, resistance.breakout->H};
  drag.onset = resistance.onset;
  drag.residual = resistance.residual;
  drag.berm = resistance.berm;
  return drag;
}

void take_drags(Results& results, const Path& path, const run_folder::History& history, const BodyScale& scale)
{
  std::optional<Real> V_max;
  if (const TravelCurve V(path.push.w, path.push.V); !V.empty()) {
    const TravelCurve smooth = V.smoothed(half_of_push(V, scale));
    V_max = *std::max_element(smooth.value().begin(), smooth.value().end());
  }
  // One without a number keeps its place: the names of the first stand alone.
  for (std::size_t k = 0; k < path.drags.size(); ++k) results.drags.push_back(drag_results(path, k, history, V_max, scale));
}

const settings::StageSettings& asked_of(const Stages& stages, const std::string& name)
{
  return std::find_if(stages.begin(), stages.end(), [&](const Stage& stage) { return stage.name == name; })->asked;
}

void take_other_pushes(Results& results, const Path& path, const run_folder::History& history, const Stages& stages, const BodyScale& scale)
{
  for (const OtherPush& push : path.other_pushes) {
    const Index last = push.rows.back();
    const Real V = history.by_label("V")[last], w = history["w_m"][last];
    if (std::isfinite(V) && std::isfinite(w))
      results.other_pushes.push_back({push.stage, w, V, given_by_push(asked_of(stages, push.stage), w)});
    if (!push.upwards) continue;
    if (std::optional<UpliftResults> uplift = uplift_of(push, history, scale)) results.uplifts.push_back(*uplift);
  }
}

/// Of all pushes before the first drag that the push end may be of.
void take_what_the_push_is_given(Results& results, const Stages& stages)
{
  if (!results.push_end) return;
  for (const Stage& stage : stages) {
    if (stage.kind == settings::StageKind::drag) return;
    const Prescribed given = given_by_push(stage.asked, results.push_end->w);
    results.push_given.w = results.push_given.w || given.w;
    results.push_given.V = results.push_given.V || given.V;
  }
}

/// The rows of all pushes and drags.
std::vector<Index> driven_rows(const Path& path)
{
  std::vector<Index> rows = path.push.rows;
  for (const OtherPush& push : path.other_pushes) rows.insert(rows.end(), push.rows.begin(), push.rows.end());
  for (const DragPath& drag : path.drags) rows.insert(rows.end(), drag.rows.begin() + (drag.rows.size() > 1 ? 1 : 0), drag.rows.end());
  return rows;
}

void take_contact(Results& results, const Path& path, const run_folder::History& history)
{
  Real max = -infinity, sum = 0;
  Index overlaps = 0, gaps = 0;
  for (const Index k : driven_rows(path)) {
    if (history.has("overlap_m") && !std::isnan(history["overlap_m"][k])) max = std::max(max, history["overlap_m"][k]), ++overlaps;
    if (history.has("gap_m") && std::isfinite(history["gap_m"][k])) sum += history["gap_m"][k], ++gaps;
  }
  if (overlaps > 0) results.overlap_max = max;
  if (gaps > 0) results.gap_mean = sum / gaps;
}

void take_second_impulse(Results& results, const PushPath& path, const run_folder::History& history)
{
  constexpr const char* label = "second impulse";
  if (!history.has_label(label)) return;
  const std::vector<Real>&second_impulse = history.by_label(label), &reaction = history.by_label("V");
  Real second = 0, V = 0;
  for (const Index k : path.rows) {
    if (!std::isfinite(second_impulse[k]) || !std::isfinite(reaction[k])) continue;
    second += second_impulse[k];
    V += reaction[k];
  }
  if (V != 0) results.second_impulse_over_V = second / std::abs(V);
}

}  // namespace

Real V_at_end(const PushPath& push, const run_folder::History& history, const Stages& stages, const BodyScale& scale)
{
  if (const Real limit = force_that_ended(push, history, stages); std::isfinite(limit)) return limit;
  const TravelCurve V(push.w, push.V);
  return V.empty() ? nan : V.at(V.end(), half_of_push(V, scale));
}

Results results_from(const run_folder::History& history, const BodyScale& scale, const Stages& stages)
{
  const Path path = path_of(history, stages);
  Results results;
  results.main = path.main;
  take_push(results, path.push, history, stages, scale);
  take_travel(results, path.push, history, scale);
  take_drags(results, path, history, scale);
  take_other_pushes(results, path, history, stages, scale);
  take_what_the_push_is_given(results, stages);
  take_second_impulse(results, path.push, history);
  take_contact(results, path, history);
  return results;
}

namespace {

constexpr Real small = 1e-3;           // of the force times D
constexpr Real part_of_travel = 0.25;  // of a short way: half of what is averaged over at most

/// The moments of these rows at the end of their travel, m, beside a force of this size, N.
void add_end(std::vector<run_folder::Quantity>& list, const record::RunRecord& run, const std::vector<Index>& rows,
             const std::vector<Real>& travel, const std::vector<Real>& force, const char* way)
{
  if (rows.size() < 3) return;
  const base::BodyScale scale = base::body_scale(run);
  const Real half = std::min(base::averaging_half(scale), part_of_travel * std::abs(travel.back() - travel.front()));
  const auto at_end = [&](const std::vector<Real>& values) {
    const record::TravelCurve curve(travel, values);
    return curve.empty() ? nan : curve.at(curve.end(), half);
  };
  const Real noise = small * std::abs(at_end(force)) * scale.width;
  for (const char axis : {'x', 'y', 'z'}) {
    const std::vector<Real>& column = run.history[fmt::format("M{}_Nm", axis)];
    std::vector<Real> moment;
    for (const Index row : rows) moment.push_back(column[row]);
    if (const Real M = at_end(moment); std::abs(M) > noise)
      list.push_back({fmt::format("M{}_end_of_{}", axis, way), M, "N m",
                      fmt::format("moment of the soil about {}, through the centre of the body", axis)});
  }
}

}  // namespace

std::vector<run_folder::Quantity> moments_in_space(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> list;
  if (run.settings.geometry != settings::Geometry::space || !run.history.has("Mx_Nm") || !run.history.has("w_m")) return list;
  const Path path = path_of(run.history, stages_of(run.settings));
  add_end(list, run, path.push.rows, path.push.w, path.push.V, "push");
  add_end(list, run, path.drag().rows, path.drag().travel, path.drag().H, "drag");
  return list;
}

}  // namespace berm::driven
