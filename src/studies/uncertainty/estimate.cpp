// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/estimate.hpp"

#include <algorithm>
#include <array>

namespace berm::uncertainty {
namespace {

/// The order of convergence is near 1 and not known well: from about 3/4, for which the way to size 0 is half as long again, to 3/2, for which it is half as long.
constexpr Real uncertain_part = 0.5;

}  // namespace

Real student_95(int degrees_of_freedom)
{
  constexpr std::array quantiles = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  if (degrees_of_freedom < 1) return nan;
  return quantiles[static_cast<std::size_t>(std::min<int>(degrees_of_freedom, quantiles.size())) - 1];
}

Estimate extrapolate(const std::vector<SizedNumber>& numbers)
{
  Real weights = 0, mean_size = 0, mean = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = 1 / (size * size);
    weights += weight;
    mean_size += weight * size;
    mean += weight * number;
  }
  mean_size /= weights;
  mean /= weights;
  Real along = 0, product = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = 1 / (size * size);
    along += weight * (size - mean_size) * (size - mean_size);
    product += weight * (size - mean_size) * (number - mean);
  }
  const int more = static_cast<int>(numbers.size()) - 2;
  if (more < 1 || !(along > 0)) return {nan, nan, nan};
  const Real slope = product / along, converged = mean - slope * mean_size;
  Real squares = 0;
  for (const auto& [size, number] : numbers) squares += std::pow((number - converged - slope * size) / size, 2);
  const Real deviation = std::sqrt(squares / more * (1 / weights + mean_size * mean_size / along));
  return {converged, uncertain_part * std::abs(slope), student_95(more) * deviation};
}

Real half_width(Real extrapolation, Real mesh, Real noise, Real speed)
{
  return extrapolation + std::sqrt(mesh * mesh + noise * noise + speed * speed);
}

}  // namespace berm::uncertainty
