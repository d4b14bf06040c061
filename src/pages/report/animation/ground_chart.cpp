// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/ground_chart_test.cpp
#include "report/animation/ground_chart.hpp"

#include "os/error.hpp"
#include "run_folder/ground.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using run_folder::FrameFiles;
using run_folder::SavedSoil;

constexpr std::size_t max_outlines = 8;  // besides that of the start
constexpr Real beside_path = 2.5;        // D, of ground that is shown

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
  for (const Index k : run_folder::ground_points(soil)) {
    if (soil.x[k] < shown.from || soil.x[k] > shown.to) continue;
    curve.x.push_back(soil.x[k]), curve.y.push_back(soil.y[k]);
    curve.rows.push_back(row);
  }
  return curve;
}

}  // namespace

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
