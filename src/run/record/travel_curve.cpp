// SPDX-License-Identifier: BSD-3-Clause
#include "record/travel_curve.hpp"

#include <algorithm>

namespace berm::record {
namespace {

constexpr std::size_t max_marks = 2000;    // each takes a sum over its window
constexpr std::size_t max_points = 10000;  // that are averaged as they are

/// Half of the window of a line that is drawn over this travel, at most.
Real drawn_half(Real travel)
{
  return travel / 20;
}

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

std::vector<Real> TravelCurve::marks() const
{
  if (travel_.size() <= max_marks) return travel_;
  std::vector<Real> marks(max_marks, end());
  for (std::size_t k = 0; k + 1 < max_marks; ++k) marks[k] = begin() + static_cast<Real>(k) / (max_marks - 1) * (end() - begin());
  return marks;
}

namespace {

/// The curve through what `value` says at these travels.
template <class Value>
TravelCurve through(const std::vector<Real>& travels, const Value& value)
{
  std::vector<Real> values;
  for (const Real s : travels) values.push_back(value(s));
  return {travels, values};
}

}  // namespace

TravelCurve TravelCurve::smoothed(Real half) const
{
  return through(marks(), [half, curve = condensed(half)](Real s) { return curve.at(s, half); });
}

Real TravelCurve::drawn_at(Real s, Real half) const
{
  return at(s, std::min({half, drawn_half(end() - begin()), std::max(Real(0), s - begin())}));
}

TravelCurve TravelCurve::drawn(Real half) const
{
  return through(marks(), [half, curve = condensed(half)](Real s) { return curve.drawn_at(s, half); });
}

std::vector<Real> drawn_along(const std::vector<Real>& travel, const std::vector<Real>& value, Real half)
{
  if (half == 0) return value;
  std::vector<Real> drawn(travel.size(), nan);
  const TravelCurve curve = TravelCurve(travel, value).condensed(half);
  if (curve.empty()) return drawn;
  const Real least_way_back = std::min(half, drawn_half(curve.end() - curve.begin()));
  Real farthest = -infinity;
  for (const Real s : travel) {
    if (std::isnan(s)) continue;
    if (farthest - s > least_way_back) return drawn;
    farthest = std::max(farthest, s);
  }
  for (std::size_t k = 0; k < travel.size(); ++k)
    if (!std::isnan(travel[k])) drawn[k] = curve.drawn_at(travel[k], half);
  return drawn;
}

}  // namespace berm::record
