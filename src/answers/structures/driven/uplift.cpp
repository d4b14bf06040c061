// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/uplift_test.cpp
#include "structures/driven/uplift.hpp"

#include "structures/driven/resistance.hpp"

#include <algorithm>

namespace berm::driven {

LiftPath lift_path(const OtherPush& lift, const run_folder::History& history)
{
  LiftPath path;
  const std::vector<Real>&w = history["w_m"], &V = history.by_label("V");
  const Index first = std::max<Index>(0, lift.rows.front() - 1);
  path.w_begin = w[first];
  if (first != lift.rows.front()) path.rows.push_back(first);
  path.rows.insert(path.rows.end(), lift.rows.begin(), lift.rows.end());
  for (const Index k : path.rows) path.travel.push_back(path.w_begin - w[k]), path.R.push_back(-V[k]);
  return path;
}

std::optional<UpliftResults> uplift_of(const OtherPush& lift, const run_folder::History& history, const BodyScale& scale)
{
  const LiftPath path = lift_path(lift, history);
  const record::TravelCurve R(path.travel, path.R);
  if (R.travel().size() < 3) return {};
  const Resistance resistance = resistance_to(R, scale);
  if (!resistance.largest || !(resistance.largest->H > 0)) return {};
  UpliftResults uplift{.stage = lift.stage};
  uplift.w_begin = path.w_begin;
  const auto& peak = resistance.breakout ? resistance.breakout : resistance.largest;
  uplift.largest = {peak->u, peak->H};
  // By row: half of it may be mobilised within less than what forces are averaged over.
  for (std::size_t k = 0; k < R.travel().size() && std::isnan(uplift.half_travel); ++k)
    if (R.value()[k] >= peak->H / 2) uplift.half_travel = R.travel()[k];
  const Real half = residual_travel(R.end() - R.begin(), scale) / 2;
  uplift.end = DragPoint{R.end(), history["w_m"][lift.rows.back()], R.at(R.end() - half, half), 0};
  return uplift;
}

}  // namespace berm::driven
