// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample_statistics.hpp"

#include <algorithm>
#include <numeric>

namespace berm::study {
namespace {

/// The place of each value in order, from 0; equal ones have the mean of theirs.
std::vector<Real> places_of(const std::vector<Real>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<Real> places(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t k = first; k < end; ++k) places[order[k]] = static_cast<Real>(first + end - 1) / 2;
  }
  return places;
}

}  // namespace

Real sample_quantile(std::vector<Real> values, Real p)
{
  std::sort(values.begin(), values.end());
  const auto count = static_cast<Real>(values.size());
  const Real place = p * count - 0.5, rounding = 1e-9;
  if (values.empty() || place < -rounding || place > count - 1 + rounding) return nan;
  const Real first = std::clamp<Real>(std::floor(place + rounding), 0, count - 1);
  const auto k = static_cast<std::size_t>(first);
  return k + 1 < values.size() ? values[k] + std::max<Real>(0, place - first) * (values[k + 1] - values[k]) : values[k];
}

Real mean_of(const std::vector<Real>& values)
{
  return values.empty() ? nan : std::accumulate(values.begin(), values.end(), Real(0)) / static_cast<Real>(values.size());
}

Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y)
{
  if (x.size() < 3) return nan;
  const std::vector<Real> of_x = places_of(x), of_y = places_of(y);
  const Real middle = static_cast<Real>(x.size() - 1) / 2;
  Real xy = 0, xx = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xy += (of_x[k] - middle) * (of_y[k] - middle);
    xx += (of_x[k] - middle) * (of_x[k] - middle);
    yy += (of_y[k] - middle) * (of_y[k] - middle);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : nan;
}

}  // namespace berm::study
