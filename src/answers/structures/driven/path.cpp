// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/path_test.cpp
#include "structures/driven/path.hpp"

#include "settings/symmetry.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::driven {
namespace {

using settings::StageKind;
using settings::StageRole;
using settings::StageSettings;

/// A stage of kind drive as the push or drag that it is; empty where it drives neither x nor y.
std::optional<StageSettings> as_push_or_drag(StageSettings s)
{
  if (s.kind == StageKind::push || s.kind == StageKind::drag) return s;
  if (s.kind != StageKind::drive) return {};
  const settings::FreedomSettings &x = s.drive.x, &y = s.drive.y;
  for (const auto& [down, up] : {std::pair{"V", "y_force"}, {"w", "y_velocity"}, {"w_displacement", "y_displacement"}})
    for (const Real value : s.loads.of(up)) s.loads.of(down).push_back(-value);
  const auto moves = [&](const settings::FreedomSettings& f, settings::LoadAlong along) {
    return f.velocity.value_or(0) != 0 || f.force || s.loads.drives(along);
  };
  if (moves(x, settings::LoadAlong::x)) {
    s.kind = StageKind::drag;
    s.velocity = x.velocity, s.force = x.force;
    s.vertical = y.hold || y.force || y.free || !s.loads.of("V").empty() ? settings::Vertical::hold : settings::Vertical::fixed;
    if (y.force) s.vertical_force = -*y.force;
    if (y.velocity) s.vertical_velocity = -*y.velocity;
    s.loads.of("H") = s.loads.of("x_force");
    s.loads.of("u") = s.loads.of("x_velocity");
    s.loads.of("u_displacement") = s.loads.of("x_displacement");
    return s;
  }
  if (!moves(y, settings::LoadAlong::y)) return {};
  s.kind = StageKind::push;
  if (y.velocity) s.velocity = -*y.velocity;
  if (y.force) s.force = -*y.force;
  return s;
}

/// Whether a push by velocity goes up for most of its way.
bool goes_up(const StageSettings& s)
{
  if (const std::vector<Real>& way = s.loads.of("w_displacement"); !way.empty()) return way.back() < 0;
  std::vector<Real> velocity = s.loads.of("w");
  if (velocity.empty())
    for (const Real factor : s.load_factors) velocity.push_back(factor * s.velocity.value_or(0));
  if (velocity.empty()) return s.velocity.value_or(0) < 0;
  Real way = 0;
  for (std::size_t k = 1; k < velocity.size(); ++k) way += (velocity[k] + velocity[k - 1]) / 2 * (s.load_times[k] - s.load_times[k - 1]);
  return way < 0;
}

/// The value of a drive at the end of its load history: `constant` times the last factor, or the last of the column; empty where it has neither.
std::optional<Real> last_value(const StageSettings& s, const std::optional<Real>& constant, const char* column)
{
  if (const std::vector<Real>& values = s.loads.of(column); !values.empty()) return values.back();
  if (!constant) return {};
  return *constant * (s.load_factors.empty() ? 1 : s.load_factors.back());
}

/// The velocity of a drag over its load history; none where it is constant.
std::vector<Real> velocities(const StageSettings& s)
{
  if (!s.loads.of("u").empty()) return s.loads.of("u");
  std::vector<Real> list;
  if (s.velocity)
    for (const Real factor : s.load_factors) list.push_back(factor * *s.velocity);
  return list;
}

Stage stage_of(const StageSettings& s, Real held_force)
{
  Stage stage{.name = s.name, .kind = s.kind, .asked = s};
  if (s.kind == StageKind::push) {
    stage.upwards = goes_up(s);
    stage.force = last_value(s, s.force, "V");
    return stage;
  }
  stage.direction = s.velocity.value_or(0) < 0 || s.force.value_or(0) < 0 ? -1 : 1;
  stage.by_force = s.force || !s.loads.of("H").empty() || s.water;
  stage.varies = stage.by_force && !s.load_times.empty();
  stage.holds_V = s.vertical == settings::Vertical::hold && !s.vertical_velocity && !s.loads.drives(settings::LoadAlong::downwards);
  if (s.vertical_force) stage.V_ramp = s.ramp;
  if (stage.holds_V && !std::isnan(held_force)) stage.held_force = held_force;
  return stage;
}

/// The parts of a drag by a history of velocity or displacement between which it turns round.
Stages parts_of(const Stage& whole)
{
  const StageSettings& s = whole.asked;
  if (whole.kind != StageKind::drag || whole.by_force) return {whole};
  const std::vector<Real> velocity = velocities(s), &way = s.loads.of("u_displacement");
  if (velocity.empty() && way.empty()) return {whole};
  Stages parts;
  const auto begin_part = [&](Real time, Real value) {
    if (value == 0) return;
    const Real direction = value < 0 ? -1 : 1;
    if (!parts.empty() && parts.back().direction == direction) return;
    if (!parts.empty()) parts.back().to = time;
    parts.push_back(whole);
    parts.back().direction = direction;
    parts.back().from = parts.size() == 1 ? 0 : time;
  };
  const auto time = [&](std::size_t k) { return s.time_scale * s.load_times[k]; };
  for (std::size_t k = 1; k < way.size(); ++k) begin_part(time(k - 1), way[k] - way[k - 1]);
  if (!velocity.empty()) begin_part(0, velocity.front());
  for (std::size_t k = 1; k < velocity.size(); ++k) {
    const Real before = velocity[k - 1], after = velocity[k];
    const bool crosses = before * after < 0;
    begin_part(crosses ? std::lerp(time(k - 1), time(k), before / (before - after)) : time(k - 1), after);
  }
  if (parts.size() > 1)
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].name = fmt::format("{}_{}", s.name, k + 1);
  return parts;
}

/// Whether a stage of a case unloads, as far as those before it tell.
bool unloads(const Stages& stages, std::size_t number)
{
  const Stage& stage = stages[number];
  if (stage.kind != StageKind::push) return false;
  if (stage.upwards) return true;
  if (!stage.force) return false;
  while (number-- > 0) {
    const Stage& earlier = stages[number];
    if (earlier.asked.vertical_force) return *stage.force < *earlier.asked.vertical_force;
    if (earlier.kind == StageKind::push && earlier.asked.until.force) return *stage.force < *earlier.asked.until.force;
    if (earlier.kind == StageKind::push && earlier.force) return *stage.force < *earlier.force;
  }
  return true;
}

/// Marks the drags that lay the pipe: those of that role, and where no role is said those that longest_lay describes.
void mark_what_lays(Stages& stages, Real D)
{
  bool said = false;
  for (Stage& stage : stages) {
    said = said || stage.asked.role != StageRole::automatic;
    stage.lays = stage.kind == StageKind::drag && stage.asked.role == StageRole::lay;
  }
  if (said || !(D > 0)) return;
  const auto travel = [](const Stage& stage) { return stage.asked.until.displacement.value_or(infinity); };
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const Stage& stage = stages[k];
    if (stage.kind != StageKind::drag || stage.by_force || travel(stage) > longest_lay * D) continue;
    bool unloaded = false;
    for (std::size_t later = k + 1; later < stages.size(); ++later) {
      unloaded = unloaded || unloads(stages, later);
      if (unloaded && stages[later].kind == StageKind::drag && travel(stages[later]) > 2 * travel(stage)) stages[k].lays = true;
    }
  }
}

/// The rows of a stage, which is run once, or of a part of it.
std::vector<Index> rows_of(const run_folder::History& history, const Stage& stage)
{
  const std::string& name = stage.asked.name.empty() ? stage.name : stage.asked.name;
  std::vector<Index> rows;
  const std::vector<Real>& time = history["time_s"];
  Real began = nan;
  for (Index k = 0; k < history.rows(); ++k) {
    if (history.stage[k] != name) continue;
    if (std::isnan(began)) began = time[std::max<Index>(0, k - 1)];
    if ((stage.from <= 0 || time[k] > began + stage.from) && time[k] <= began + stage.to) rows.push_back(k);
  }
  return rows;
}

DragPath drag_path(const run_folder::History& history, const Stage& stage, std::vector<Index> rows)
{
  const auto &u = history["u_m"], &w = history["w_m"], &H = history.by_label("H"), &V = history.by_label("V");
  if (rows.front() > 0) rows.insert(rows.begin(), rows.front() - 1);
  DragPath path{.stage = stage, .rows = std::move(rows)};
  path.u_begin = u[path.rows.front()];
  for (const Index k : path.rows) {
    path.travel.push_back(stage.direction * (u[k] - path.u_begin));
    path.w.push_back(w[k]);
    path.H.push_back(stage.direction * H[k]);
    path.V.push_back(V[k]);
  }
  return path;
}

template <class List>
const DragPath& drag_or_none(const List& drags, std::size_t number)
{
  static const DragPath none_yet{};
  return number < drags.size() ? drags[number] : none_yet;
}

}  // namespace

Stages stages_of(const settings::Case& c, const std::vector<Real>& held_forces)
{
  Stages stages;
  const Index main = main_rigid(c);
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    if (!c.stage[k].rigid.empty() && c.stage[k].rigid != c.rigid[main].first) continue;
    const std::optional<StageSettings> s = as_push_or_drag(c.stage[k]);
    const bool still = s && s->velocity && *s->velocity == 0;
    if (!s || (s->kind == StageKind::drag && still)) continue;
    for (Stage& part : parts_of(stage_of(*s, k < held_forces.size() ? held_forces[k] : nan))) stages.push_back(std::move(part));
  }
  mark_what_lays(stages, base::body_scale(c).width);
  return stages;
}

std::optional<std::size_t> main_drag(const Stages& stages)
{
  std::optional<std::size_t> first, last;
  std::size_t number = 0;
  for (const Stage& stage : stages) {
    if (stage.kind != StageKind::drag) continue;
    if (stage.asked.role == StageRole::breakout) return number;
    if (!first && !stage.lays) first = number;
    last = number++;
  }
  return first ? first : last;
}

std::vector<Real> settled_V(const DragPath& drag, const std::vector<Real>& time)
{
  const Real from = time[drag.rows.front()] + drag.stage.V_ramp;
  std::vector<Real> force;
  for (std::size_t k = 1; k < drag.rows.size(); ++k)  // the first row is the last of the stage before
    if (time[drag.rows[k]] >= from && !std::isnan(drag.V[k])) force.push_back(drag.V[k]);
  return force;
}

const DragPath& Path::drag() const
{
  return drag_or_none(drags, 0);
}

const DragPath& Path::main_drag() const
{
  return drag_or_none(drags, main);
}

Real force_that_ended(const PushPath& push, const run_folder::History& history, const Stages& stages)
{
  constexpr Real noise = 0.05;  // a row may have so much less than the mean that ends a push
  constexpr Real same_depth = 1e-3;
  if (push.rows.empty()) return nan;
  const auto stage = std::ranges::find(stages, history.stage[push.rows.back()], &Stage::name);
  if (stage == stages.end() || !stage->asked.until.force) return nan;
  const settings::Until& until = stage->asked.until;
  const bool deep = until.embedment && push.w.back() >= (1 - same_depth) * *until.embedment;
  const Real least = until.time || until.displacement ? 1 : 1 - noise;
  return !deep && push.V.back() >= least * *until.force ? *until.force : nan;
}

Path path_of(const run_folder::History& history, const Stages& stages)
{
  constexpr Real carried = 0.05;  // of V where a lift begins: with less left of it the soil no longer carries the body
  const auto pulls_up = [](const Stage& stage) { return stage.upwards || stage.force.value_or(0) < 0; };
  Path path;
  path.main = main_drag(stages).value_or(0);
  if (history.rows() == 0) return path;
  const std::vector<Real>&w = history["w_m"], &V = history.by_label("V");
  for (const Stage& stage : stages) {
    std::vector<Index> rows = rows_of(history, stage);
    if (rows.empty()) continue;
    if (stage.kind == StageKind::drag) {
      path.drags.push_back(drag_path(history, stage, std::move(rows)));
      continue;
    }
    const bool unloads = stage.upwards || (stage.force && rows.front() > 0 && *stage.force < V[rows.front() - 1]);
    // After an unloading only what goes beyond the push loads the body further.
    const bool reloads = !path.other_pushes.empty() && stage.force && !path.push.V.empty() && *stage.force <= path.push.V.back();
    if (unloads || reloads || !path.drags.empty()) {
      const bool lifts = pulls_up(stage) && !(V[rows.back()] > carried * std::abs(V[std::max(rows.front() - 1, 0)]));
      path.other_pushes.push_back({stage.name, stage.upwards, lifts, std::move(rows)});
      continue;
    }
    for (const Index k : rows) {
      path.push.rows.push_back(k);
      path.push.w.push_back(w[k]);
      path.push.V.push_back(V[k]);
    }
  }
  return path;
}

}  // namespace berm::driven
