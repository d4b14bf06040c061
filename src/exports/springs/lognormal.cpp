// SPDX-License-Identifier: BSD-3-Clause
#include "springs/lognormal.hpp"

#include "study/sample.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berm::springs {

bool Lognormal::fits() const
{
  return distance <= lognormal_limit;
}

Real Lognormal::quantile(Real p) const
{
  return std::exp(mean + deviation * study::standard_normal_quantile(p));
}

Lognormal fit_lognormal(std::vector<Real> values)
{
  constexpr std::size_t least = 5;
  constexpr Real prescribed = 1e-3;  // relative: values so near each other are one number that the input gave
  if (values.size() < least || !std::all_of(values.begin(), values.end(), [](Real value) { return value > 0; })) return {};
  const auto n = static_cast<Real>(values.size());
  for (Real& value : values) value = std::log(value);
  std::sort(values.begin(), values.end());
  if (values.back() - values.front() < prescribed) return {};
  Lognormal fit;
  fit.mean = std::accumulate(values.begin(), values.end(), Real(0)) / n;
  Real squares = 0;
  for (const Real value : values) squares += (value - fit.mean) * (value - fit.mean);
  fit.deviation = std::sqrt(squares / (n - 1));
  Real largest = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Real share = 0.5 * std::erfc(-(values[k] - fit.mean) / fit.deviation / std::sqrt(Real(2))), place = static_cast<Real>(k);
    largest = std::max({largest, share - place / n, (place + 1) / n - share});
  }
  fit.distance = largest * (std::sqrt(n) - 0.01 + 0.85 / std::sqrt(n));
  return fit;
}

}  // namespace berm::springs
