// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/mechanism.hpp"

#include "material/clay.hpp"
#include "os/error.hpp"
#include "run_folder/ground.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace berm::driven {
namespace {

constexpr Real beside_pipe = 1.5, around_pipe = 4;  // of D
constexpr Real column_width = 0.1;                  // of D
constexpr Real a_tenth = 0.1, nine_tenths = 0.9, a_hundredth = 0.01;

/// The volume of a particle's square that lies above a level.
Real volume_above(const run_folder::SavedSoil& soil, std::size_t k, Real level)
{
  const Real side = std::sqrt(Real(soil.volume[k]));
  return side * std::clamp(soil.y[k] + side / 2 - level, Real(0), side);
}

using Columns = std::map<Index, Real>;

/// Height of the particles above the surface by column, counted from the pipe's centre: m.
Columns columns_of_particles(const run_folder::SavedSoil& soil, const problem::BedSurface& surface, Real center, Real width)
{
  Columns columns;
  for (std::size_t k = 0; k < soil.x.size(); ++k)
    columns[static_cast<Index>(std::floor((soil.x[k] - center) / width))] += volume_above(soil, k, surface.at(soil.x[k])) / width;
  return columns;
}

/// The mean of what of a line is positive, between its ends.
Real mean_above(Real begin, Real end)
{
  const auto [low, high] = std::minmax(begin, end);
  if (low >= 0) return (low + high) / 2;
  return high > 0 ? high * high / (2 * (high - low)) : 0;
}

/// The same of finite elements. What lies below an overhang of the ground, along which x falls, is taken off.
Columns columns_of_elements(const run_folder::SavedSoil& soil, const problem::BedSurface& surface, Real center, Real width)
{
  Columns columns;
  const std::vector<Index> ground = run_folder::ground_points(soil);
  for (std::size_t k = 1; k < ground.size(); ++k) {
    const Real x[] = {soil.x[ground[k - 1]], soil.x[ground[k]]}, y[] = {soil.y[ground[k - 1]], soil.y[ground[k]]};
    const auto [left, right] = std::minmax(x[0], x[1]);
    if (!(left < right)) continue;
    const auto height_at = [&](Real at) { return y[0] + (at - x[0]) / (x[1] - x[0]) * (y[1] - y[0]) - surface.at(at); };
    const auto column_at = [&](Real at) { return static_cast<Index>(std::floor((at - center) / width)); };
    for (Index column = column_at(left); column <= column_at(right); ++column) {
      const Real from = std::max(left, center + static_cast<Real>(column) * width),
                 to = std::min(right, center + static_cast<Real>(column + 1) * width);
      if (from < to) columns[column] += (x[1] > x[0] ? 1 : -1) * (to - from) * mean_above(height_at(from), height_at(to)) / width;
    }
  }
  return columns;
}

Columns columns_above(const run_folder::SavedSoil& soil, const problem::BedSurface& surface, Real center, Real width)
{
  return (soil.triangles.empty() ? columns_of_particles : columns_of_elements)(soil, surface, center, width);
}

/// How much higher it is now than at the start.
Columns rises(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const problem::BedSurface& surface, Real center,
              Real width)
{
  Columns columns = columns_above(now, surface, center, width);
  for (const auto& [column, height] : columns_above(start, surface, center, width)) columns[column] -= height;
  return columns;
}

/// The plastic shear strain at which clay has lost half of what remoulding takes; 0 where the soil does not soften, or has several materials.
Real half_remoulded(const DrivenRun& run)
{
  const std::optional<settings::BodySoil> soil = base::touched_soil(run.record);
  if (!soil || soil->materials.size() > 1) return 0;
  const auto* clay = soil->materials.front().get_if<material::Clay>();
  return clay != nullptr && clay->sensitivity > 1 ? clay->ductility * std::log(2.) / 3 : 0;
}

Real start_of_pipe(const settings::Case& c)
{
  return center_of<2>(make_shape<2>(c.rigid[main_rigid(c)].second.shape))[0];
}

}  // namespace

Heave heave_of(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const problem::BedSurface& surface,
               const BodyPlace& pipe, Real diameter)
{
  const Real width = column_width * diameter;
  Heave heave{-infinity, -infinity, 0};
  const auto max = static_cast<Index>(beside_pipe / column_width);
  for (const auto& [column, rise] : rises(start, now, surface, pipe.x, width)) {
    if (column >= 0) heave.berm += std::max(Real(0), rise) * width;
    if (column < -max || column >= max) continue;
    Real& highest = column < 0 ? heave.behind : heave.ahead;
    highest = std::max(highest, rise);
  }
  return heave;
}

Berm berm_of(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const problem::BedSurface& surface,
             const BodyPlace& pipe, Real direction, Real diameter)
{
  const Real width = column_width * diameter;
  Berm berm{0, 0};
  for (const auto& [column, rise] : rises(start, now, surface, pipe.x, width)) {
    const Real ahead = direction * (static_cast<Real>(column) + 0.5) * width;
    if (ahead < 0 || rise <= 0) continue;
    if (ahead <= around_pipe * diameter && rise > berm.height) berm.height = rise, berm.distance = ahead;
  }
  return berm;
}

RemouldedClay remoulded_clay(const run_folder::SavedSoil& now, Real limit, Real invert, const BodyPlace& pipe, Real diameter)
{
  const std::vector<float>& shear = now["plastic_shear"];
  RemouldedClay clay{0, 0};
  for (std::size_t k = 0; k < now.x.size(); ++k) {
    if (!(shear[k] > limit)) continue;
    clay.area += now.volume[k];
    if (std::abs(now.x[k] - pipe.x) <= diameter / 2) clay.depth = std::max(clay.depth, invert - now.y[k]);
  }
  return clay;
}

Mechanism mechanism_of(const run_folder::SavedSoil& before, const run_folder::SavedSoil& after, const problem::BedSurface& surface,
                       const BodyPlace& from, const BodyPlace& to, Real diameter)
{
  if (before.x.size() != after.x.size() || before.triangles != after.triangles)
    throw RunError(fmt::format("{}: its points are not those of the frame before it", after.file.string()));
  std::vector<std::size_t> close;
  std::vector<Real> growth;
  const std::vector<float>& increment = after["incremental_deviatoric_strain"];
  for (std::size_t k = 0; k < after.x.size(); ++k) {
    if (std::abs(after.x[k] - to.x) > around_pipe * diameter) continue;
    close.push_back(k);
    growth.push_back(increment[k]);
  }
  if (close.empty()) return {0, 0, nan};
  std::vector<Real> sorted = growth;
  std::sort(sorted.begin(), sorted.end());
  const Real min = a_tenth * sorted[static_cast<std::size_t>((1 - a_hundredth) * static_cast<Real>(sorted.size() - 1))];

  Real all = 0, behind = 0, heaped = 0, dragged = 0;
  std::vector<std::pair<Real, Real>> ahead;  // distance, shearing
  for (std::size_t n = 0; n < close.size(); ++n) {
    const std::size_t k = close[n];
    const Real distance = after.x[k] - to.x, shearing = growth[n] > min ? growth[n] * after.volume[k] : 0;
    all += shearing;
    if (distance < 0) {
      behind += shearing;
      continue;
    }
    ahead.emplace_back(distance, shearing);
    if (after.y[k] <= surface.at(after.x[k])) continue;
    heaped += after.volume[k];
    if (after.x[k] - before.x[k] >= a_tenth * (to.x - from.x)) dragged += after.volume[k];
  }
  std::sort(ahead.begin(), ahead.end());
  Real reach = 0, sum = 0;
  for (const auto& [distance, shearing] : ahead) {
    if (sum >= nine_tenths * (all - behind)) break;
    sum += shearing;
    reach = distance;
  }
  return {all > 0 ? behind / all : 0, reach, dragged / heaped};
}

BodyFrames::BodyFrames(const DrivenRun& run)
{
  if (run.history.rows() == 0 || run.settings.geometry != settings::Geometry::plane_strain) return;
  try {
    files_ = run_folder::frame_files(run.record.folder / "frames");
  } catch (const RunError&) {
    return;  // the film says what is wrong with them
  }
  const Real start = start_of_pipe(run.settings);
  const std::vector<Real>&time = run.history["time_s"], &u = run.history["u_m"], &w = run.history["w_m"];
  for (const run_folder::FrameFiles& frame : files_) {
    // A frame is written where a row is or between two: the row that follows is of the same stage.
    const auto row = std::min<std::ptrdiff_t>(std::lower_bound(time.begin(), time.end(), frame.time * (1 - 1e-12)) - time.begin(),
                                              static_cast<std::ptrdiff_t>(time.size()) - 1);
    places_.push_back({start + u[row], u[row], w[row]});
    const auto stage = std::find_if(run.settings.stage.begin(), run.settings.stage.end(),
                                    [&](const settings::StageSettings& s) { return s.name == run.history.stage[row]; });
    kinds_.push_back(stage == run.settings.stage.end() ? settings::StageKind::free : stage->kind);
    stages_.push_back(run.history.stage[row]);
  }
}

std::optional<std::size_t> BodyFrames::nearest(settings::StageKind kind, Real BodyPlace::*quantity, Real value) const
{
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < count(); ++k)
    if (kinds_[k] == kind && (!found || std::abs(places_[k].*quantity - value) < std::abs(places_[*found].*quantity - value))) found = k;
  return found;
}

std::optional<std::size_t> BodyFrames::last(settings::StageKind kind) const
{
  for (std::size_t k = count(); k-- > 0;)
    if (kinds_[k] == kind) return k;
  return std::nullopt;
}

std::optional<std::size_t> BodyFrames::last(const std::string& stage) const
{
  for (std::size_t k = count(); k-- > 0;)
    if (stages_[k] == stage) return k;
  return std::nullopt;
}

void take_berms(Results& results, const DrivenRun& run)
{
  if (results.drags.empty()) return;
  const BodyFrames frames(run);
  if (frames.count() == 0 || run.settings.small_strain()) return;
  try {
    const run_folder::SavedSoil start = frames.soil(0);
    const Real limit = half_remoulded(run);
    for (DragResults& drag : results.drags) {
      const auto stage = std::find_if(run.stages.begin(), run.stages.end(), [&](const Stage& s) { return s.name == drag.stage; });
      const std::optional<std::size_t> frame = frames.last(drag.stage);
      if (stage == run.stages.end() || !frame || *frame == 0) continue;
      const run_folder::SavedSoil now = frames.soil(*frame);
      if (!now.triangles.empty() && run_folder::ground_points(now).empty()) continue;
      const BodyPlace& place = frames.place(*frame);
      const Berm berm = berm_of(start, now, run.record.bed_surface(), place, stage->direction, run.scale.width);
      drag.berm_height = berm.height;
      if (berm.height > 0) drag.berm_distance = berm.distance;
      if (!(limit > 0)) continue;
      const RemouldedClay clay = remoulded_clay(now, limit, run.record.bed_surface().at(place.x) - place.w, place, run.scale.width);
      drag.remoulded_depth = clay.depth;
      drag.remoulded_area = clay.area / (run.scale.width * run.scale.width);
    }
  } catch (const RunError&) {  // the film says which frame is damaged
  }
}

}  // namespace berm::driven
