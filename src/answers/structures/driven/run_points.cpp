// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/resistance_test.cpp
#include "structures/driven/run_points.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

constexpr Real embedded_beyond = 0.01;  // of D

/// The embedment of the main rigid body as the case places it, m; NaN where there is none.
Real placed_w(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const Index rigid = main_rigid(c);
  if (rigid == none) return nan;
  const bodies::RigidShapeSettings& shape = c.rigid[rigid].second.shape;
  if (!run.ground.line.level()) {
    const bodies::RigidShape<2> plane = bodies::make_shape<2>(shape);
    return run.surface_at(center_of<2>(plane)[0]) - bodies::lowest_level<2>(plane, Vec<2>::UnitY());
  }
  return c.surface - (c.dimension() == 2 ? bodies::lowest_level<2>(bodies::make_shape<2>(shape), Vec<2>::UnitY())
                                         : bodies::lowest_level<3>(bodies::make_shape<3>(shape), Vec<3>::UnitY()));
}

/// Whether the run's history ends in one of these stages, by name.
bool ends_in(const DrivenRun& run, const std::vector<std::string>& stages)
{
  return run.history.rows() > 0 && std::find(stages.begin(), stages.end(), run.history.stage.back()) != stages.end();
}

bool knows_w(const run_folder::History& history)
{
  return history.rows() > 0 && history.has("w_m");
}

/// The embedment at which the push begins: in the row before its first, as far as there is one.
Real push_begin(const DrivenRun& run, Real first_w)
{
  if (!knows_w(run.history)) return first_w;
  const PushPath push = path_of(run.history, run.stages).push;
  return push.rows.empty() ? first_w : run.history["w_m"][std::max(push.rows.front() - 1, 0)];
}

StageEnd end_of(const DrivenRun& run, const char* stage, bool reached)
{
  if (reached) return {true, fmt::format("to the end of the {}", stage), fmt::format("end of the {}", stage)};
  if (run.end == record::RunEnd::stopped) return {false, "to where it was stopped", "where it was stopped"};
  return {false, "as far as it got", "as far as it got"};
}

}  // namespace

RunPoints points_of(const DrivenRun& run)
{
  RunPoints points;
  const Real D = run.scale.width;
  points.first_w = knows_w(run.history) ? run.history["w_m"].front() : placed_w(run.record);
  Results results = run.results();
  points.push = std::move(results.push);
  points.push_end = results.push_end;
  points.drag = results.main_drag().points;
  const Real begin = push_begin(run, points.first_w), end = points.push_end ? points.push_end->w : nan;
  std::erase_if(points.push,
                [&](const PushPoint& p) { return std::abs(p.w - begin) < same_point * D || std::abs(p.w - end) < same_point * D; });
  return points;
}

StageEnd end_of_push(const DrivenRun& run)
{
  std::vector<std::string> pushes;
  for (const Stage& stage : run.stages) {
    if (stage.kind == settings::StageKind::drag) break;
    pushes.push_back(stage.asked.name);
  }
  const bool last = run.history.rows() > 0 ? ends_in(run, pushes) : run.results().drags.empty();
  return end_of(run, "push", run.end == record::RunEnd::finished || !last);
}

StageEnd end_of_drag(const DrivenRun& run)
{
  const std::optional<std::size_t> main = main_drag(run.stages);
  std::size_t number = 0;
  bool last = run.history.rows() == 0;
  for (const Stage& stage : run.stages)
    if (stage.kind == settings::StageKind::drag && number++ == main) last = last || ends_in(run, {stage.asked.name});
  return end_of(run, "drag", run.end == record::RunEnd::finished || !last);
}

bool starts_embedded(const DrivenRun& run)
{
  return points_of(run).first_w > embedded_beyond * run.scale.width;
}

}  // namespace berm::driven
