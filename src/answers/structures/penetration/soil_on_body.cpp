// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/soil_on_body.hpp"

#include "os/error.hpp"
#include "structures/driven/path.hpp"

#include <algorithm>
#include <set>

namespace berm::penetration {
namespace {

/// The soil in the frame that is nearest to the end of the push.
std::optional<run_folder::SavedSoil> soil_at_end(const PenetrationRun& run)
{
  const record::RunRecord& record = run.record;
  if (record.folder.empty() || run.z().empty() || !(run.z_end() > 0) || record.settings.geometry == settings::Geometry::space) return {};
  const std::vector<Index> rows = driven::path_of(record.history, driven::stages_of(record.settings)).push.rows;
  const Real time = record.history["time_s"][rows.back()];
  try {
    const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(record.folder / "frames");
    const auto frame = std::ranges::min_element(frames, {}, [&](const run_folder::FrameFiles& f) { return std::abs(f.time - time); });
    return frame == frames.end() ? std::nullopt : std::optional(run_folder::read_soil(frame->soil));
  } catch (const RunError&) {
    return {};  // the page says so where it shows the frames
  }
}

}  // namespace

Real backflow_pressure(const PenetrationRun& run)
{
  const std::optional<run_folder::SavedSoil> soil = soil_at_end(run);
  if (!soil) return nan;
  const Real level = run.record.settings.surface - run.z_end();
  const bool round = run.record.settings.geometry == settings::Geometry::axisymmetric;  // a frame then has areas of the section
  Real volume = 0;
  for (std::size_t k = 0; k < soil->x.size(); ++k)
    if (soil->x[k] > run.body.left && soil->x[k] < run.body.right && soil->y[k] > level)
      volume += (round ? 2 * pi * soil->x[k] : 1) * soil->volume[k];
  return run.soil.at(run.z_end()).unit_weight * volume / run.area();
}

Real soil_above(const run_folder::SavedSoil& soil, Real x, Real top, Real width)
{
  constexpr int columns = 3, rows = 6;  // of squares, on each side: half of its half width across, half a width up
  const Real side = width / (2 * rows);
  std::set<std::pair<int, int>> filled;
  for (std::size_t k = 0; k < soil.x.size(); ++k) {
    const Real column = std::floor(std::abs(soil.x[k] - x) / side), row = std::floor((soil.y[k] - top) / side);
    if (column < columns && row >= 0 && row < rows) filled.emplace(static_cast<int>(column), static_cast<int>(row));
  }
  return static_cast<Real>(filled.size()) / (columns * rows);
}

Real soil_above_at_end(const PenetrationRun& run)
{
  if (run.record.settings.method != settings::Method::mpm) return nan;
  const std::optional<run_folder::SavedSoil> soil = soil_at_end(run);
  if (!soil) return nan;
  const Real top = run.record.settings.surface - run.w_end() + run.body.height;
  return soil_above(*soil, (run.body.left + run.body.right) / 2, top, run.body.width);
}

}  // namespace berm::penetration
