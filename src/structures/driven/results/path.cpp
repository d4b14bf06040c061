// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/results/path.hpp"

namespace berm::driven {
namespace {

using problem::StageKind;
using problem::StageSettings;

Stage pipe_stage(const StageSettings& s, Real held_force)
{
  Stage stage;
  stage.name = s.name;
  stage.kind = s.kind;
  if (s.kind == StageKind::push) {
    const Real last = s.load_factors.empty() ? 1 : s.load_factors.back();
    stage.upwards = s.velocity.value_or(0) * last < 0;
    if (s.force) stage.force = *s.force * last;
    return stage;
  }
  stage.direction = s.velocity.value_or(0) < 0 || s.force.value_or(0) < 0 ? -1 : 1;
  stage.holds_V = s.vertical == problem::Vertical::hold && !s.vertical_velocity;
  if (s.vertical_force) stage.V_ramp = s.ramp;
  if (stage.holds_V && !std::isnan(held_force)) stage.held_force = held_force;
  return stage;
}

/// The rows of a stage, which is run once.
std::vector<Index> rows_of(const run_folder::History& history, const std::string& stage)
{
  std::vector<Index> rows;
  for (Index k = 0; k < history.rows(); ++k)
    if (history.stage[k] == stage) rows.push_back(k);
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

}  // namespace

Stages stages_of(const problem::Case& c, const std::vector<Real>& held_forces)
{
  Stages stages;
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const StageSettings& s = c.stage[k];
    const bool still = s.velocity && *s.velocity == 0;
    if (s.kind == StageKind::push || (s.kind == StageKind::drag && !still))
      stages.push_back(pipe_stage(s, k < held_forces.size() ? held_forces[k] : nan));
  }
  return stages;
}

const DragPath& Path::drag() const
{
  static const DragPath none_yet{};
  return drags.empty() ? none_yet : drags.front();
}

Path path_of(const run_folder::History& history, const Stages& stages)
{
  Path path;
  if (history.rows() == 0) return path;
  const std::vector<Real>&w = history["w_m"], &V = history.by_label("V");
  for (const Stage& stage : stages) {
    std::vector<Index> rows = rows_of(history, stage.name);
    if (rows.empty()) continue;
    if (stage.kind == StageKind::drag) {
      path.drags.push_back(drag_path(history, stage, std::move(rows)));
      continue;
    }
    const bool unloads = stage.upwards || (stage.force && rows.front() > 0 && *stage.force < V[rows.front() - 1]);
    if (unloads || !path.drags.empty()) {
      path.other_pushes.push_back({stage.name, std::move(rows)});
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
