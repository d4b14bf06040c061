// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/results/moments_in_space.hpp"

#include "record/travel_curve.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/pipe/results/pipe_path.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

constexpr Real small = 1e-3;           // of the force times D
constexpr Real part_of_travel = 0.25;  // of a short way: half of what is averaged over at most

/// The moments of these rows at the end of their travel, m, beside a force of this size, N.
void add_end(std::vector<run_folder::Quantity>& list, const record::RunRecord& run, const std::vector<Index>& rows,
             const std::vector<Real>& travel, const std::vector<Real>& force, const char* way)
{
  if (rows.size() < 3) return;
  const base::BodyScale scale = base::body_scale(run);
  const Real half = std::min(base::averaging_half(scale), part_of_travel * std::abs(travel.back() - travel.front()));
  const auto at_end = [&](const std::vector<Real>& values) {
    const record::TravelCurve curve(travel, values);
    return curve.empty() ? nan : curve.at(curve.end(), half);
  };
  const Real noise = small * std::abs(at_end(force)) * scale.width;
  for (const char axis : {'x', 'y', 'z'}) {
    const std::vector<Real>& column = run.history[fmt::format("M{}_Nm", axis)];
    std::vector<Real> moment;
    for (const Index row : rows) moment.push_back(column[row]);
    if (const Real M = at_end(moment); std::abs(M) > noise)
      list.push_back({fmt::format("M{}_end_of_{}", axis, way), M, "N m",
                      fmt::format("moment of the soil about {}, through the centre of the body", axis)});
  }
}

}  // namespace

std::vector<run_folder::Quantity> moments_in_space(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> list;
  if (run.settings.geometry != problem::Geometry::space || !run.history.has("Mx_Nm") || !run.history.has("w_m")) return list;
  const PipePath path = pipe_path(run.history, pipe_stages(run.settings));
  add_end(list, run, path.push.rows, path.push.w, path.push.V, "push");
  add_end(list, run, path.drag().rows, path.drag().travel, path.drag().H, "drag");
  return list;
}

}  // namespace berm::pipe
