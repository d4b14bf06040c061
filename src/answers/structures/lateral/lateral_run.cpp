// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/lateral_run.hpp"

#include "bodies/rigid/rotation.hpp"
#include "core/axes.hpp"
#include "structures/penetration/soil_profile.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr Real largest_half = 1. / 40;  // of the way: half of what is averaged over
constexpr Real upright = 1e-9;          // rad

/// The rows of the stages that load the body sideways, from the first such stage to the last, and the row before them.
std::vector<Index> loaded_rows(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const auto loads = [&](const std::string& name) {
    return std::any_of(c.stage.begin(), c.stage.end(),
                       [&](const settings::StageSettings& stage) { return stage.name == name && base::goes_sideways(c, stage); });
  };
  std::vector<Index> rows;
  for (Index k = 0; k < run.history.rows(); ++k) {
    if (!loads(run.history.stage[k])) continue;
    if (rows.empty() && k > 0) rows.push_back(k - 1);
    rows.push_back(k);
  }
  return rows;
}

/// Three columns of a history as vectors.
class Vectors {
public:
  Vectors(const run_folder::History& history, const char* symbol, const char* ending)
  {
    for (int d = 0; d < 3; ++d) columns_[d] = &history[fmt::format("{}{}_{}", symbol, "xyz"[d], ending)];
  }
  Vec<3> operator[](Index row) const { return {(*columns_[0])[row], (*columns_[1])[row], (*columns_[2])[row]}; }

private:
  std::array<const std::vector<Real>*, 3> columns_{};
};

/// The height of the point on which the first load acts, m, of a body that it may turn; NaN where the case names none.
Real point_height_of(const settings::Case& c, const Axes<3>& axes)
{
  for (const settings::StageSettings& stage : c.stage) {
    if (!base::goes_sideways(c, stage)) continue;
    const settings::DriveSettings& drive = stage.drive;
    const bool turns = drive.rotation_x.free || drive.rotation_y.free || drive.rotation_z.free;
    return turns && !drive.point.empty() ? axes.height(bodies::to_vec<3>(drive.point)) : nan;
  }
  return nan;
}

/// The horizontal axis along which the body goes farthest, towards there.
Vec<3> direction_of(const Vectors& displacement, const std::vector<Index>& rows, int up)
{
  Vec<3> farthest = Vec<3>::Zero(), direction = Vec<3>::Zero();
  direction[up == 0 ? 1 : 0] = 1;
  Real largest = 0;
  for (const Index row : rows) {
    farthest = displacement[row] - displacement[rows.front()];
    farthest[up] = 0;
    int axis = 0;
    if (const Real size = farthest.cwiseAbs().maxCoeff(&axis); size > largest) {
      largest = size;
      direction.setZero();
      direction[axis] = farthest[axis] < 0 ? -1 : 1;
    }
  }
  return direction;
}

}  // namespace

LateralPath lateral_path(const record::RunRecord& run)
{
  LateralPath path;
  const run_folder::History& history = run.history;
  if (history.rows() == 0 || !base::is_loaded_sideways(run.settings) || !history.has("dx_m") || !history.has("anglex_rad")) return path;
  const std::vector<Index> rows = loaded_rows(run);
  if (rows.size() < 3) return path;
  const Vectors d(history, "d", "m"), F(history, "F", "N"), M(history, "M", "Nm"), angle(history, "angle", "rad");
  const Axes<3> axes = axes_of<3>(bodies::to_vec<3>(run.settings.gravity));
  const Vec<3> center = center_of<3>(bodies::make_shape<3>(run.settings.rigid[main_rigid(run.settings)].second.shape));
  const Real bed = axes.sign * run.surface_at(center[axes.along]);
  const Vec<3> up = axes.up_vector(), along = direction_of(d, rows, axes.up), about = bodies::cross(up, along);
  const Index first = rows.front();
  const auto above_bed = [&](Index row) { return axes.height(Vec<3>(center + d[row])) - bed; };
  path.rows = rows;
  path.length = history["w_m"][first];
  path.direction = along[axes.along];
  path.point_height = point_height_of(run.settings, axes) - bed;
  for (const Index row : rows) {
    const Real tilt = (angle[row] - angle[first]).dot(about), height = above_bed(row);
    // Across the axis and about its point at the seabed: the force of the load, and its moment.
    const Real across = -F[row].dot(along) + F[row].dot(up) * std::tan(tilt), moment = -M[row].dot(about) + height * across;
    path.u.push_back((d[row] - d[first]).dot(along) - above_bed(first) * std::sin(tilt));
    path.tilt.push_back(tilt);
    path.H.push_back(-F[row].dot(along));
    path.M.push_back(moment);
    path.height.push_back(moment / across);
  }
  return path;
}

LateralRun::LateralRun(const record::RunRecord& run, std::size_t number_on_page)
    : record(run),
      number(number_on_page),
      path(lateral_path(run)),
      H_({}, {})
{
  if (path.empty()) return;
  const base::BodyScale scale = base::body_scale(run);
  width = scale.width;
  constexpr int points = 50;
  const penetration::SoilProfile soil(run);
  strength = 0;
  for (int k = 0; k < points; ++k) strength += soil.at((k + 0.5) / points * path.length).strength / points;
  H_ = record::TravelCurve(path.u, path.H);
  if (H_.empty()) return;
  half_ = std::min(base::averaging_half(scale), largest_half * (H_.end() - H_.begin()));
  take_results();
}

Real LateralRun::strength_at(Real depth) const
{
  return strength > 0 ? penetration::SoilProfile(record).at(depth).strength : nan;
}

void LateralRun::take_results()
{
  const auto at_end = [&](const std::vector<Real>& values) {
    const record::TravelCurve curve(path.u, values);
    return curve.at(curve.end(), half_);
  };
  LateralResults& r = results_;
  r.u = H_.end();
  r.H = at_end(path.H), r.M = at_end(path.M), r.tilt = at_end(path.tilt);
  r.height = std::isfinite(path.point_height) ? path.point_height : at_end(path.height);
  r.u_load = r.u + r.height * std::sin(r.tilt);
  if (std::abs(r.tilt) > upright) r.pivot = r.u / std::sin(r.tilt);
  const record::TravelCurve smooth = H_.smoothed(half_);
  const auto largest = std::max_element(smooth.value().begin(), smooth.value().end());
  r.max_H = *largest, r.u_at_max = smooth.travel()[largest - smooth.value().begin()];
}

}  // namespace berm::lateral
