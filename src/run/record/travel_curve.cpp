// SPDX-License-Identifier: BSD-3-Clause
#include "record/travel_curve.hpp"

#include <algorithm>

namespace berm::record {
namespace {

constexpr std::size_t max_marks = 2000;    // each takes a sum over its window
constexpr std::size_t max_points = 10000;  // that are averaged as they are

}  // namespace

TravelCurve::TravelCurve(const std::vector<Real>& travel, const std::vector<Real>& value)
{
  for (std::size_t k = 0; k < travel.size(); ++k) {
    if (std::isnan(travel[k]) || std::isnan(value[k]) || (!travel_.empty() && travel[k] <= travel_.back())) continue;
    travel_.push_back(travel[k]);
    value_.push_back(value[k]);
  }
}

Real TravelCurve::interpolated(Real s) const
{
  const auto above = std::lower_bound(travel_.begin(), travel_.end(), s) - travel_.begin();
  if (above == 0) return value_.front();
  const Real part = (s - travel_[above - 1]) / (travel_[above] - travel_[above - 1]);
  return value_[above - 1] + part * (value_[above] - value_[above - 1]);
}

Real TravelCurve::at(Real s, Real half) const
{
  if (empty() || s < begin() || s > end()) return nan;
  const Real from = std::max(begin(), std::min(s - half, end() - 2 * half)), to = std::min(end(), std::max(s + half, begin() + 2 * half));
  const auto first = std::lower_bound(travel_.begin(), travel_.end(), from) - travel_.begin();
  const auto last = std::upper_bound(travel_.begin(), travel_.end(), to) - travel_.begin() - 1;
  if (last - first < 2) return interpolated(s);
  Real weight = 0, mean_s = 0, mean_y = 0, along = 0, product = 0;
  const auto weight_of = [&](auto k) { return (travel_[std::min(k + 1, last)] - travel_[std::max(k - 1, first)]) / 2; };
  for (auto k = first; k <= last; ++k) {
    const Real w = weight_of(k);
    weight += w;
    mean_s += w * (travel_[k] - s);
    mean_y += w * value_[k];
  }
  mean_s /= weight;
  mean_y /= weight;
  for (auto k = first; k <= last; ++k) {
    const Real w = weight_of(k), ds = travel_[k] - s - mean_s;
    along += w * ds * ds;
    product += w * ds * (value_[k] - mean_y);
  }
  return mean_y - product / along * mean_s;
}

TravelCurve TravelCurve::condensed(Real half) const
{
  if (travel_.size() <= max_points) return *this;
  std::vector<Real> means_s{begin()}, means_y{value_.front()};
  for (std::size_t k = 1; k + 1 < travel_.size();) {
    Real weight = 0, sum_s = 0, sum_y = 0;
    for (const Real reach = travel_[k] + half / 50; k + 1 < travel_.size() && travel_[k] <= reach; ++k) {
      const Real w = (travel_[k + 1] - travel_[k - 1]) / 2;
      weight += w;
      sum_s += w * travel_[k];
      sum_y += w * value_[k];
    }
    means_s.push_back(sum_s / weight);
    means_y.push_back(sum_y / weight);
  }
  means_s.push_back(end());
  means_y.push_back(value_.back());
  return {means_s, means_y};
}

TravelCurve TravelCurve::smoothed(Real half) const
{
  const TravelCurve short_enough = condensed(half);
  std::vector<Real> marks = travel_, values;
  if (marks.size() > max_marks) {
    marks.resize(max_marks);
    for (std::size_t k = 0; k < max_marks; ++k)
      marks[k] = k + 1 == max_marks ? end() : begin() + static_cast<Real>(k) / (max_marks - 1) * (end() - begin());
  }
  for (const Real s : marks) values.push_back(short_enough.at(s, half));
  return {marks, values};
}

}  // namespace berm::record
