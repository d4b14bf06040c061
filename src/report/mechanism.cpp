// SPDX-License-Identifier: BSD-3-Clause
#include "report/mechanism.hpp"

#include "bodies/rigid.hpp"

#include <algorithm>
#include <map>

namespace berm {
namespace {

constexpr Real near_pipe = 1.5;     // of D
constexpr Real column_width = 0.1;  // of D
constexpr Real most_of_it = 0.9;

Real start_of_pipe(const Case& c)
{
  return center_of<2>(make_shape<2>(c.rigid[main_rigid(c)].second.shape))[0];
}

}  // namespace

Heave heave_of(const SavedSoil& soil, Real surface, const PipePlace& pipe, Real diameter)
{
  Heave heave{0, 0, 0};
  const Real width = column_width * diameter;
  std::map<Index, Real> columns;  // volume above the surface, by column from the pipe's centre
  for (std::size_t k = 0; k < soil.x.size(); ++k) {
    if (soil.y[k] <= surface) continue;
    const Real ahead = soil.x[k] - pipe.x, volume = soil.volume[k];
    if (ahead > 0) heave.berm += volume;
    if (std::abs(ahead) <= near_pipe * diameter) columns[static_cast<Index>(std::floor(ahead / width))] += volume;
  }
  for (const auto& [column, volume] : columns) {
    Real& highest = column < 0 ? heave.behind : heave.ahead;
    highest = std::max(highest, volume / width);
  }
  return heave;
}

Shearing shearing_of(const SavedSoil& before, const SavedSoil& after, Real surface, const PipePlace& pipe)
{
  Real all = 0, behind = 0, above = 0;
  std::vector<std::pair<Real, Real>> ahead;  // distance, strain times volume
  for (std::size_t k = 0; k < after.x.size(); ++k) {
    const Real part = std::max(0.f, after.deviatoric_strain[k] - before.deviatoric_strain[k]) * after.volume[k];
    const Real distance = after.x[k] - pipe.x;
    all += part;
    if (distance < 0)
      behind += part;
    else
      ahead.emplace_back(distance, part);
    if (after.y[k] > surface) above += part;
  }
  std::sort(ahead.begin(), ahead.end());
  Real reach = 0, sum = 0;
  for (const auto& [distance, part] : ahead) {
    if (sum >= most_of_it * (all - behind)) break;
    sum += part;
    reach = distance;
  }
  return {behind / all, above / all, reach};
}

PipeFrames::PipeFrames(const RunRecord& run)
{
  if (!run.has_pipe() || run.history.rows() == 0 || run.settings.dimension != 2) return;
  files_ = frame_files(run.folder / "frames");
  const Real start = start_of_pipe(run.settings);
  const std::vector<Real>&time = run.history["time_s"], &u = run.history["u_m"], &w = run.history["w_m"];
  for (const FrameFiles& frame : files_) {
    // A frame is written where a row is or between two: the row that follows is of the same stage.
    const auto row = std::min<std::ptrdiff_t>(std::lower_bound(time.begin(), time.end(), frame.time * (1 - 1e-12)) - time.begin(),
                                              static_cast<std::ptrdiff_t>(time.size()) - 1);
    places_.push_back({start + u[row], u[row], w[row]});
    const auto stage = std::find_if(run.settings.stage.begin(), run.settings.stage.end(),
                                    [&](const StageSettings& s) { return s.name == run.history.stage[row]; });
    kinds_.push_back(stage == run.settings.stage.end() ? StageKind::free : stage->kind);
  }
}

std::optional<std::size_t> PipeFrames::nearest(StageKind kind, Real PipePlace::*quantity, Real value) const
{
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < count(); ++k)
    if (kinds_[k] == kind && (!found || std::abs(places_[k].*quantity - value) < std::abs(places_[*found].*quantity - value))) found = k;
  return found;
}

std::optional<std::size_t> PipeFrames::last(StageKind kind) const
{
  for (std::size_t k = count(); k-- > 0;)
    if (kinds_[k] == kind) return k;
  return std::nullopt;
}

}  // namespace berm
