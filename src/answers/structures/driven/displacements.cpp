// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/displacements_test.cpp
#include "structures/driven/displacements.hpp"

#include "settings/time_scale.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::driven {
namespace {

constexpr Real turn = 0.01;  // of D: less is no way back

}  // namespace

std::vector<HalfCycle> half_cycles_of(const DragPath& drag, const run_folder::History& history, Real D)
{
  std::vector<HalfCycle> cycles;
  if (drag.rows.size() < 2) return cycles;
  const std::vector<Real>&time = history["time_s"], &u = history["u_m"];
  const auto since = [&](std::size_t k) { return (time[drag.rows[k]] - time[drag.rows.front()]) / drag.stage.asked.time_scale; };
  const auto way = [&](std::size_t k) { return u[drag.rows[k]] - drag.u_begin; };
  const auto add = [&](std::size_t from, std::size_t to) { cycles.push_back({since(from), since(to), way(from), way(to), drag.w[to]}); };
  std::size_t begin = 0, farthest = 0;
  Real direction = 0;
  for (std::size_t k = 1; k < drag.rows.size(); ++k) {
    if (direction == 0) {
      if (std::abs(way(k) - way(begin)) < turn * D) continue;
      direction = way(k) > way(begin) ? 1 : -1;
      farthest = k;
    } else if (direction * (way(k) - way(farthest)) >= 0) {
      farthest = k;
    } else if (direction * (way(farthest) - way(k)) >= turn * D) {
      add(begin, farthest);
      begin = farthest, farthest = k, direction = -direction;
    }
  }
  if (direction != 0) add(begin, farthest);
  return cycles;
}

Displacements displacements_of(const DragPath& drag, const run_folder::History& history, Real D)
{
  Displacements moved;
  const std::vector<Real>&time = history["time_s"], &u = history["u_m"];
  const Real t0 = time[drag.rows.front()];
  moved.u_largest = 0, moved.w_largest = drag.w.front();
  for (std::size_t k = 0; k < drag.rows.size(); ++k) {
    const Real way = u[drag.rows[k]] - drag.u_begin, since = (time[drag.rows[k]] - t0) / drag.stage.asked.time_scale;
    if (std::abs(way) > std::abs(moved.u_largest)) moved.u_largest = way;
    moved.w_largest = std::max(moved.w_largest, drag.w[k]);
    if (!moved.time_half_D && std::abs(way) >= D / 2) moved.time_half_D = since;
    if (!moved.time_D && std::abs(way) >= D) moved.time_D = since;
  }
  moved.u_end = u[drag.rows.back()] - drag.u_begin;
  moved.w_end = drag.w.back();
  moved.largest_half_cycle = 0;
  const std::vector<HalfCycle> cycles = half_cycles_of(drag, history, D);
  for (const HalfCycle& cycle : cycles)
    moved.largest_half_cycle = std::max(moved.largest_half_cycle, std::abs(cycle.u_end - cycle.u_begin));
  moved.half_cycles = static_cast<Real>(cycles.size());
  if (drag.stage.varies) moved.time_scale = drag.stage.asked.time_scale;
  return moved;
}

bool is_accelerated(const DragPath& drag, const run_folder::History& history, Real D, Real mass)
{
  Real largest = 0;
  for (const Real H : drag.H)
    if (std::isfinite(H)) largest = std::max(largest, std::abs(H));
  return std::ranges::any_of(half_cycles_of(drag, history, D), [&](const HalfCycle& cycle) {
    const Real way = std::abs(cycle.u_end - cycle.u_begin), time = drag.stage.asked.time_scale * (cycle.end_s - cycle.begin_s),
               rate = time > 0 ? pi / time : 0;
    return way > breaks_out * D || mass * (way / 2) * rate * rate > inertia_matters * largest;
  });
}

std::vector<std::string> time_scale_lines(const record::RunRecord& run)
{
  std::vector<std::string> lines;
  for (const Stage& stage : stages_of(run.settings))
    if (stage.varies) lines.push_back(fmt::format("\"{}\" is {}", stage.name, settings::time_scale_words(stage.asked)));
  return lines;
}

std::vector<std::string> lower_estimates(const record::RunRecord& run)
{
  std::vector<std::string> lines;
  if (run.history.rows() == 0 || !base::drives_a_body(run.settings)) return lines;
  const Real D = base::body_scale(run).width, mass = run.settings.rigid[main_rigid(run.settings)].second.mass;
  for (const DragPath& drag : path_of(run.history, stages_of(run.settings)).drags) {
    if (!drag.stage.varies || !(drag.stage.asked.time_scale < 1) || !is_accelerated(drag, run.history, D, mass)) continue;
    const Displacements moved = displacements_of(drag, run.history, D);
    lines.push_back(
        fmt::format("the displacement in \"{}\" is a lower estimate: its record ran with time_scale = {:.3g}, and the {} moved by {:.2g} D "
                    "in a half cycle; {}. Run with time_scale = 1",
                    drag.stage.name, drag.stage.asked.time_scale, base::body_word(run.settings), moved.largest_half_cycle / D,
                    settings::breakout_takes_time));
  }
  return lines;
}

std::string half_cycles_csv(const run_folder::History& history, const Stages& stages, Real D)
{
  std::string csv;
  for (const DragPath& drag : path_of(history, stages).drags) {
    if (!drag.stage.varies) continue;
    int number = 0;
    for (const HalfCycle& c : half_cycles_of(drag, history, D))
      csv += fmt::format("{},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n", drag.stage.name, ++number, c.begin_s, c.end_s, c.u_begin, c.u_end,
                         c.w_end);
  }
  return csv.empty() ? "" : "stage,half_cycle,begin_s,end_s,u_begin_m,u_end_m,w_end_m\n" + csv;
}

}  // namespace berm::driven
