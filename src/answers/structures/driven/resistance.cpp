// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/resistance.hpp"

#include "structures/driven/run_points.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

using record::TravelCurve;

/// How much averaged H swings about its mean over +-0.1 D, N/m: 1.48 times the median of its distances from it, the standard deviation of normal noise, which neither the
/// rise at the begin nor a peak changes. 0 without noise.
Real swing_of(const TravelCurve& smooth, const BodyScale& scale)
{
  constexpr Real normal = 1.4826;
  if (!scale.noisy || smooth.empty()) return 0;
  std::vector<Real> off;
  for (std::size_t k = 0; k < smooth.travel().size(); ++k)
    off.push_back(std::abs(smooth.value()[k] - smooth.at(smooth.travel()[k], swing_half * scale.width)));
  std::nth_element(off.begin(), off.begin() + off.size() / 2, off.end());
  return normal * off[off.size() / 2];
}

/// The first peak that H falls from by min_fall of it, and by this fall, within a travel over D.
std::optional<Resistance::Point> breakout_in(const TravelCurve& smooth, const BodyScale& scale, Real least_fall,
                                             Real longest = longest_breakout)
{
  if (smooth.empty()) return std::nullopt;
  const Real half = averaging_half(scale), stays = scale.noisy ? breakout_stays * scale.width
                                                               : std::min(breakout_stays_without_noise * scale.width,
                                                                          max_residual_part * (smooth.end() - smooth.begin()));
  Resistance::Point peak{0, 0};
  bool fallen = false;
  for (std::size_t k = 0; k < smooth.travel().size(); ++k) {
    const Real u = smooth.travel()[k], here = smooth.value()[k];
    if (u < smooth.begin() + half || u > smooth.end() - half) continue;
    if (here > peak.H) {
      if (u > smooth.begin() + longest * scale.width) return std::nullopt;
      peak = {u, here};
      fallen = false;
      continue;
    }
    fallen = fallen || here <= peak.H - std::max(min_fall * peak.H, least_fall);
    if (!fallen || !(peak.H > 0) || u < peak.u + stays) continue;
    // A single increment that relaxes falls, too: without noise the mean of so long a way must be lower by as much.
    if (scale.noisy || smooth.at(u - stays / 2, stays / 2) <= (1 - min_fall) * peak.H) return peak;
  }
  return std::nullopt;
}

/// Where H that falls from no peak leaves its first steep rise; empty where the drag is too short to tell, or H grows from nothing.
std::optional<Real> onset_of(const TravelCurve& H, Real D)
{
  constexpr Real half = 0.1, from_nothing = 0.1;  // of D, of each window; of H in the first
  if (H.end() - H.begin() < 0.5 * D) return {};
  const Real first = H.at(H.begin() + 0.2 * D, half * D), second = H.at(H.begin() + 0.4 * D, half * D),
             onset = std::min(first, 2 * first - second);
  return onset > from_nothing * first ? std::optional(onset) : std::nullopt;
}

/// From where H stays near the residual over this stretch, or to the end.
std::optional<Real> residual_from(const TravelCurve& smooth, Real breakout, Real residual, Real stretch)
{
  std::optional<Real> from;
  for (std::size_t k = 0; k < smooth.travel().size(); ++k) {
    const Real u = smooth.travel()[k];
    if (u < breakout) continue;
    if (std::abs(smooth.value()[k] - residual) > max_residual_change * std::abs(residual))
      from.reset();
    else if (!from)
      from = u;
    else if (u - *from >= stretch)
      return from;
  }
  return from;
}

/// The lowest mean of H over a stretch of 2 half, beyond `from`, in which it changes as little as at the end of a drag, and the middle of that stretch; empty where
/// there is none.
std::optional<Resistance::Point> plateau_of(const TravelCurve& H, Real from, Real half)
{
  std::optional<Resistance::Point> lowest;
  for (Real u = from + half; u + half <= H.end(); u += half / 2) {
    const Real mean = H.at(u, half), first = H.at(u - half / 2, half / 2), second = H.at(u + half / 2, half / 2),
               middle = H.at(u, half / 2);
    // The means of two halves differ by half of what a straight line changes; a trough has a low middle.
    const Real most = max_residual_change / 2 * mean;
    if (mean > 0 && std::abs(second - first) < most && std::abs(middle - mean) < most && (!lowest || mean < lowest->H))
      lowest = Resistance::Point{u, mean};
  }
  return lowest;
}

/// Where H first comes to a value.
Real first_at(const TravelCurve& smooth, Real value)
{
  for (std::size_t k = 0; k < smooth.travel().size(); ++k)
    if (smooth.value()[k] >= value) return smooth.travel()[k];
  return smooth.end();
}

void take_if_larger(std::optional<Resistance::Point>& largest, Real u, Real H)
{
  if (std::isfinite(H) && (!largest || H > largest->H)) largest = Resistance::Point{u, H};
}

}  // namespace

Real residual_travel(Real travel, const BodyScale& scale)
{
  return std::min(max_residual_part * travel, std::max(residual_part * travel, min_residual_travel * scale.width));
}

Ahead ahead_of(const Path& path, std::size_t number, const BodyScale& scale)
{
  const DragPath& drag = path.drags[number];
  if (drag.travel.empty()) return Ahead::fresh;
  Ahead ahead = Ahead::fresh;
  for (std::size_t k = 0; k < number; ++k) {
    const DragPath& earlier = path.drags[k];
    if (earlier.stage.lays || earlier.stage.by_force || earlier.travel.empty()) continue;
    if (ahead == Ahead::fresh) ahead = Ahead::swept;
    if (earlier.stage.direction != drag.stage.direction) continue;
    // Where the earlier one ended, along the travel of this one.
    const Real end = drag.stage.direction * (earlier.u_begin - drag.u_begin) + earlier.travel.back();
    if (end > least_way_to_a_berm * scale.width && std::abs(drag.travel.back() - end) <= near_a_berm * scale.width) return Ahead::berm;
  }
  return ahead;
}

Resistance resistance_to(const TravelCurve& H, const BodyScale& scale, Ahead ahead)
{
  Resistance resistance;
  resistance.travel = resistance.V_at_largest = resistance.last_change = nan;
  if (H.travel().size() < 3) return resistance;
  resistance.travel = H.end();
  const TravelCurve smooth = H.smoothed(averaging_half(scale));
  for (std::size_t k = 0; k < smooth.travel().size(); ++k) take_if_larger(resistance.largest, smooth.travel()[k], smooth.value()[k]);
  const Real least_fall = min_fall_over_swing * swing_of(smooth, scale);
  resistance.breakout = breakout_in(smooth, scale, least_fall);
  resistance.peak_beyond = !resistance.breakout && breakout_in(smooth, scale, least_fall, infinity);
  resistance.peak_in_noise = !resistance.breakout && breakout_in(smooth, scale, 0);
  if (!resistance.breakout) resistance.onset = onset_of(H, scale.width);
  const Real travel = H.end() - H.begin();
  const Real half = residual_travel(travel, scale) / 2;
  const Real mean = H.at(H.end() - half, half);
  resistance.last_change = 2 * (H.at(H.end(), half) - mean) / std::abs(mean);
  if (ahead != Ahead::berm && std::abs(resistance.last_change) < max_residual_change)
    resistance.residual = mean, resistance.residual_at = H.end() - half;
  if (travel >= min_travel_to_a_berm * scale.width && mean > 0) {
    // Without a breakout H grows from nothing: a plateau is a longer stretch then.
    const std::optional<Resistance::Point> plateau = resistance.breakout
                                                         ? plateau_of(H, resistance.breakout->u, half)
                                                         : plateau_of(H, first_at(smooth, mean / 2), std::max(half, travel / 8));
    const bool risen = plateau && mean > (1 + min_berm) * plateau->H,
               away = plateau && ahead == Ahead::berm && plateau->u < H.end() - near_a_berm * scale.width;
    if (risen || away) resistance.residual = plateau->H, resistance.residual_at = plateau->u;
    if (risen) resistance.berm = mean;
  }
  const bool grows = ahead == Ahead::berm || (ahead == Ahead::swept && resistance.last_change > 0);
  if (!resistance.residual && grows && mean > 0) resistance.berm = mean;
  if (resistance.residual && resistance.breakout)
    resistance.residual_from = residual_from(smooth, resistance.breakout->u, *resistance.residual, half);
  return resistance;
}

Resistance resistance_in(const Path& path, std::size_t drag, const BodyScale& scale)
{
  return resistance_to({path.drags[drag].travel, path.drags[drag].H}, scale, ahead_of(path, drag, scale));
}

Resistance resistance_of(const DrivenRun& run)
{
  const Path path = run.history.rows() > 0 ? path_of(run.history, run.stages) : Path{};
  const DragPath& drag = path.main_drag();
  if (drag.stage.varies || path.main >= path.drags.size()) return resistance_to({{}, {}}, run.scale);
  Resistance resistance = resistance_in(path, path.main, run.scale);
  const std::optional<DragPeak> peak = run.results().main_drag().largest;
  if (!resistance.largest && peak) take_if_larger(resistance.largest, peak->u, peak->H);
  // The points need not be among the travels at which a long curve is looked at.
  for (const DragPoint& p : points_of(run).drag) take_if_larger(resistance.largest, p.u, p.H);
  if (resistance.largest) resistance.V_at_largest = TravelCurve(drag.travel, drag.V).at(resistance.largest->u, averaging_half(run.scale));
  return resistance;
}

std::string no_peak_words(const Resistance& resistance, const std::string& end)
{
  const char* none = resistance.peak_in_noise ? "no peak above the noise of H" : resistance.peak_beyond ? "no peak within 1 D" : "no peak";
  if (resistance.residual) return fmt::format("{}: H levels off", none);
  if (resistance.berm) return fmt::format("{}: H grows against a berm", none);
  return resistance.last_change > 0 ? fmt::format("{}: H grows {}", none, end) : none;
}

}  // namespace berm::driven
