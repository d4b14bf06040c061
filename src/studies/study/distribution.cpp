// SPDX-License-Identifier: BSD-3-Clause
#include "study/distribution.hpp"

namespace berm::study {
namespace {

Real standard_normal_share(Real z)
{
  return 0.5 * std::erfc(-z / std::sqrt(2.));
}

bool is_unbounded(const Distribution& d)
{
  return d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal;
}

/// A normal distribution whose halves have deviations of their own, of a value or of its logarithm.
struct Halves {
  Real best, below, above;

  explicit Halves(const Distribution& d)
  {
    const Real low = along(d, d.low), high = along(d, d.high), z = standard_normal_quantile(high_share);
    best = d.best ? along(d, *d.best) : (low + high) / 2;
    below = (best - low) / z;
    above = (high - best) / z;
  }
  static Real along(const Distribution& d, Real value) { return d.kind == DistributionKind::lognormal ? std::log(value) : value; }
  static Real back(const Distribution& d, Real y) { return d.kind == DistributionKind::lognormal ? std::exp(y) : y; }

  Real at(Real p) const
  {
    const Real z = standard_normal_quantile(p);
    return best + z * (z < 0 ? below : above);
  }
  /// The share of values below y.
  Real share(Real y) const { return standard_normal_share((y - best) / (y < best ? below : above)); }
};

Real triangular_quantile(Real min, Real peak, Real max, Real p)
{
  const Real rising = (peak - min) / (max - min);  // the share below the peak
  return p < rising ? min + std::sqrt(p * (max - min) * (peak - min)) : max - std::sqrt((1 - p) * (max - min) * (max - peak));
}

}  // namespace

void describe(Describe& d, Distribution& distribution)
{
  const auto number = [&](const char* key, auto& value, const char* meaning, bool required) {
    d.value(key, value, {.meaning = meaning, .required = required, .any_unit = &distribution.unit});
  };
  d.choice("distribution", distribution.kind, distribution_words, {.meaning = "how the values are distributed"});
  number("low", distribution.low, "least value of a uniform or triangular one, 5 % value of the others", true);
  number("best", distribution.best, "most likely value of a triangular one, 50 % value of a normal or lognormal one; absent: the middle",
         false);
  number("high", distribution.high, "greatest value of a uniform or triangular one, 95 % value of the others", true);
  number("min", distribution.min, "no value of a normal or lognormal one lies below", false);
  number("max", distribution.max, "no value of a normal or lognormal one lies above", false);
}

void check(Describe& d, const std::string& path, const Distribution& c)
{
  d.check(c.low < c.high, path + ".low", "must be less than high");
  const bool triangular = c.kind == DistributionKind::triangular;
  if (c.kind == DistributionKind::uniform) d.check(!c.best, path + ".best", "a uniform distribution has only low and high");
  if (triangular) d.check(c.best.has_value(), path, "a triangular distribution needs best, its most likely value");
  if (c.best && triangular) d.check(c.low <= *c.best && *c.best <= c.high, path + ".best", "must lie from low to high");
  if (c.best && is_unbounded(c)) d.check(c.low < *c.best && *c.best < c.high, path + ".best", "must lie between low and high");
  if (c.kind == DistributionKind::lognormal) d.check(c.low > 0, path + ".low", "must be more than 0 where the logarithm is distributed");
  for (const auto& [bound, key] : {std::pair(c.min, ".min"), std::pair(c.max, ".max")})
    if (bound) d.check(is_unbounded(c), path + key, "is only for normal and lognormal distributions; the others end at low and high");
  if (c.min) d.check(*c.min <= c.low, path + ".min", "must be at most low");
  if (c.max) d.check(*c.max >= c.high, path + ".max", "must be at least high");
}

Real quantile(const Distribution& d, Real p)
{
  if (d.kind == DistributionKind::uniform) return d.low + p * (d.high - d.low);
  if (d.kind == DistributionKind::triangular) return triangular_quantile(d.low, *d.best, d.high, p);
  const Halves halves(d);
  const bool logarithm_ends = d.kind == DistributionKind::lognormal && d.min && *d.min <= 0;  // it has no value there
  const Real from = d.min && !logarithm_ends ? halves.share(Halves::along(d, *d.min)) : 0,
             to = d.max ? halves.share(Halves::along(d, *d.max)) : 1;
  return Halves::back(d, halves.at(from + p * (to - from)));
}

Real standard_normal_quantile(Real p)
{
  if (p > 0.5) return -standard_normal_quantile(1 - p);
  Real low = -9, high = 0;
  while (high - low > 1e-15 * std::max<Real>(1, -low)) {
    const Real middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (standard_normal_share(middle) < p ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace berm::study
