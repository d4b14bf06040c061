// SPDX-License-Identifier: BSD-3-Clause
#include "report/resistance.hpp"

#include <algorithm>

namespace berm {
namespace {

std::optional<Resistance::Point> breakout_in(const TravelCurve& H, const PipeScale& scale)
{
  const Real half = averaging_half(scale), stays = scale.noisy ? breakout_stays * scale.diameter : 0;
  Resistance::Point peak{0, 0};
  bool fallen = false;
  for (const Real u : H.travel()) {
    if (u < H.begin() + half || u > H.end() - half) continue;
    const Real here = H.at(u, half);
    if (here > peak.H) {
      peak = {u, here};
      fallen = false;
      continue;
    }
    fallen = fallen || here <= (1 - least_fall) * peak.H;
    if (fallen && peak.H > 0 && u >= peak.u + stays) return peak;
  }
  return std::nullopt;
}

}  // namespace

Resistance resistance_to(const TravelCurve& H, const PipeScale& scale)
{
  Resistance resistance;
  resistance.last_change = std::numeric_limits<Real>::quiet_NaN();
  if (H.travel().size() < 3) return resistance;
  resistance.breakout = breakout_in(H, scale);
  const Real travel = H.end() - H.begin();
  const Real half = std::min(travel, std::max(residual_part * travel, least_residual_travel * scale.diameter)) / 2;
  const Real mean = H.at(H.end() - half, half);
  resistance.last_change = 2 * (H.at(H.end(), half) - mean) / std::abs(mean);
  if (std::abs(resistance.last_change) < most_residual_change) resistance.residual = mean;
  return resistance;
}

Resistance resistance_of(const RunRecord& run)
{
  if (!run.has_pipe() || run.history.rows() == 0) return resistance_to({{}, {}}, run.scale);
  const PipePath path = pipe_path(run.history, run.stages);
  return resistance_to({path.drag_u, path.drag_H}, run.scale);
}

std::string no_peak_words(const Resistance& resistance)
{
  if (resistance.residual) return "no peak: H levels off";
  return resistance.last_change > 0 ? "no peak: H grows to the end of the drag" : "no peak";
}

}  // namespace berm
