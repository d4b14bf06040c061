// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/ground_chart_test.cpp
#include "report/animation/ground_chart.hpp"

#include "os/error.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace berm::report {
namespace {

using run_folder::FrameFiles;
using run_folder::SavedSoil;

constexpr std::size_t max_outlines = 8;  // besides that of the start
constexpr Real beside_path = 2.5;        // D, of ground that is shown
constexpr Real on_wall = 1e-6;           // of the length of the soil

/// A side of one element alone leads from a corner of it by its middle to the next.
struct Side {
  Index middle, end;
};
using Boundary = std::multimap<Index, Side>;

Boundary boundary_of(const std::vector<std::array<Index, 6>>& triangles)
{
  std::map<std::pair<Index, Index>, std::pair<int, Index>> sides;  // how many elements have it, and its middle
  for (const std::array<Index, 6>& t : triangles)
    for (int k = 0; k < 3; ++k) {
      auto& [count, middle] = sides[std::minmax({t[k], t[(k + 1) % 3]})];
      ++count, middle = t[3 + k];
    }
  Boundary boundary;
  for (const auto& [ends, side] : sides) {
    if (side.first != 1) continue;
    boundary.insert({ends.first, {side.second, ends.second}});
    boundary.insert({ends.second, {side.second, ends.first}});
  }
  return boundary;
}

/// The last row of each stage, in the order of the stages.
std::vector<Index> ends_of_stages(const run_folder::History& history)
{
  std::vector<Index> rows;
  for (Index k = 0; k < history.rows(); ++k)
    if (k + 1 == history.rows() || history.stage[k] != history.stage[k + 1]) rows.push_back(k);
  return rows;
}

/// Every n-th, and the last.
std::vector<Index> thinned(const std::vector<Index>& rows, std::size_t step)
{
  std::vector<Index> some;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if ((rows.size() - 1 - k) % step == 0) some.push_back(rows[k]);
  return some;
}

/// Where the ground is shown, m.
struct Range {
  Real from = -infinity, to = infinity;
};

Range beside_the_path(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const Index rigid = main_rigid(c);
  const auto* circle = rigid == none ? nullptr : std::get_if<bodies::CircleSettings>(&c.rigid[rigid].second.shape);
  if (circle == nullptr || !run.history.has("u_m") || run.history.rows() == 0) return {};
  const auto [least, most] = std::ranges::minmax(run.history["u_m"]);
  const Real middle = circle->center[0], beside = beside_path * circle->diameter;
  return {middle + least - beside, middle + most + beside};
}

/// The frame of that time; null where there is none.
const FrameFiles* frame_at(const std::vector<FrameFiles>& files, Real time)
{
  const Real close = 1e-6 * std::max(std::abs(files.back().time), std::abs(time));
  const auto found = std::ranges::find_if(files, [&](const FrameFiles& frame) { return std::abs(frame.time - time) <= close; });
  return found == files.end() ? nullptr : &*found;
}

base::Curve outline_of(const SavedSoil& soil, const Range& shown, const std::string& name, Index row)
{
  base::Curve curve{.name = name};
  for (const Index k : ground_points(soil)) {
    if (soil.x[k] < shown.from || soil.x[k] > shown.to) continue;
    curve.x.push_back(soil.x[k]), curve.y.push_back(soil.y[k]);
    curve.rows.push_back(row);
  }
  return curve;
}

}  // namespace

std::vector<Index> ground_points(const SavedSoil& soil)
{
  if (soil.triangles.empty()) return {};
  const auto [left, right] = std::ranges::minmax(soil.x);
  const Real close = on_wall * (right - left);
  const auto is_at = [&](Index point, Real wall) { return std::abs(soil.x[point] - wall) <= close; };
  const Boundary boundary = boundary_of(soil.triangles);
  Index at = none;
  for (const auto& [corner, side] : boundary)
    if (is_at(corner, left) && (at == none || soil.y[corner] > soil.y[at])) at = corner;
  std::vector<Index> points = {at};
  for (Index before = none; !is_at(at, right);) {
    const auto [first, last] = boundary.equal_range(at);
    const auto next = std::find_if(first, last, [&](const auto& entry) {
      const Index end = entry.second.end;
      return end != before && !(is_at(at, left) && is_at(end, left));
    });
    if (next == last || points.size() > 2 * boundary.size()) return {};
    points.push_back(next->second.middle), points.push_back(next->second.end);
    before = at, at = next->second.end;
  }
  return points;
}

std::optional<base::Chart> ground_chart(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const run_folder::History& history = run.history;
  if (c.method != settings::Method::fem || !c.fem.large_deformation || history.rows() == 0 || !history.has("time_s")) return {};
  const std::vector<Index> ends = ends_of_stages(history);
  const std::size_t step = (ends.size() + max_outlines - 1) / max_outlines;
  base::Chart chart{"ground",
                    {"distance along the bed", "x", "m"},
                    {"height", "y", "m"},
                    {},
                    step == 1 ? "Ground at the ends of stages" : fmt::format("Ground at the ends of stages, one of {}", step)};
  try {
    const std::vector<FrameFiles> files = run_folder::frame_files(run.folder / "frames");
    if (files.empty()) return {};
    const Range shown = beside_the_path(run);
    const auto add = [&](const std::string& name, Index row) {
      const FrameFiles* frame = frame_at(files, history["time_s"][row]);
      if (frame == nullptr) return;
      if (base::Curve curve = outline_of(run_folder::read_soil(frame->soil), shown, name, row); !curve.x.empty())
        chart.curves.push_back(std::move(curve));
    };
    add("start", 0);
    for (const Index row : thinned(ends, step)) add(history.stage[row], row);
  } catch (const RunError&) {  // the outlines end before a frame that is damaged
  }
  return chart.curves.empty() ? std::nullopt : std::optional(std::move(chart));
}

}  // namespace berm::report
