// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace berm::uncertainty {
namespace {

/// The order of convergence is near 1 and not known well: from about 3/4, for which the way to size 0 is half as long again, to 3/2, for which it is half as long.
constexpr Real uncertain_part = 0.5;

/// Student's t for 95 % of a deviation that ten meshes tell.
constexpr Real student = 2.262;

/// The order p at which |f - f0| grows as size^p through three numbers, finest first; NaN where the differences are within what meshes of these sizes differ by, the
/// deviation being `scatter` of the finest, or do not have one sign.
Real order_of(std::vector<SizedNumber> numbers, Real scatter)
{
  std::ranges::sort(numbers, {}, &SizedNumber::size);
  const auto &a = numbers.front(), &b = numbers[1], &c = numbers.back();
  const Real first = b.number - a.number, second = c.number - b.number;
  if (!(std::abs(first) > scatter * std::hypot(1, b.size / a.size)) || !(first * second > 0)) return nan;
  const auto ratio = [&](Real p) { return (std::pow(c.size, p) - std::pow(b.size, p)) / (std::pow(b.size, p) - std::pow(a.size, p)); };
  Real low = 0.1, high = 4;
  if (ratio(low) > second / first || ratio(high) < second / first) return nan;
  for (int k = 0; k < 50; ++k) {
    const Real middle = (low + high) / 2;
    (ratio(middle) < second / first ? low : high) = middle;
  }
  return low;
}

}  // namespace

Estimate extrapolate(const std::vector<SizedNumber>& numbers, Real known_scatter)
{
  const int more = static_cast<int>(numbers.size()) - 2;
  if (more < 1) return {nan, nan, nan, nan, nan};
  const Real finest = std::ranges::min(numbers, {}, &SizedNumber::size).size;
  Real weights = 0, mean_size = 0, mean = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = std::pow(finest / size, 2);
    weights += weight;
    mean_size += weight * size;
    mean += weight * number;
  }
  mean_size /= weights;
  mean /= weights;
  Real along = 0, product = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = std::pow(finest / size, 2);
    along += weight * (size - mean_size) * (size - mean_size);
    product += weight * (size - mean_size) * (number - mean);
  }
  if (!(along > 0)) return {nan, nan, nan, nan, nan};
  const Real slope = product / along, converged = mean - slope * mean_size;
  Real squares = 0;
  for (const auto& [size, number] : numbers) squares += std::pow((number - converged - slope * size) * finest / size, 2);
  const Real own = std::sqrt(squares / more), scatter = std::max(known_scatter, own);
  return {converged, order_of(numbers, scatter), uncertain_part * std::abs(slope) * finest,
          student * scatter * std::sqrt(1 / weights + mean_size * mean_size / along), own};
}

Real half_width(Real extrapolation, Real mesh, Real noise, Real speed)
{
  return extrapolation + std::sqrt(mesh * mesh + noise * noise + speed * speed);
}

}  // namespace berm::uncertainty
