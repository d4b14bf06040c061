// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::study {

enum class DistributionKind { uniform, triangular, normal, lognormal };
inline const std::vector<const char*> distribution_words = {"uniform", "triangular", "normal", "lognormal"};

constexpr Real low_share = 0.05, high_share = 0.95;  ///< of all values: those below the low estimate, and below the high one

/// A distribution by its estimates, in SI units. Uniform from low to high; triangular from low to high with its peak at best; of the others 5 % of all values lie below low, a half
/// below best, and 95 % below high.
struct Distribution {
  DistributionKind kind = DistributionKind::lognormal;
  Real low = 0, high = 0;
  std::optional<Real> best;      ///< absent: the middle of low and high, of a lognormal one the middle of their logarithms
  std::optional<Real> min, max;  ///< no value lies beyond
  std::string unit;              ///< as any_unit of a parameter
};
void describe(Describe& d, Distribution& distribution);

/// Says at `path` what does not fit together.
void check(Describe& d, const std::string& path, const Distribution& distribution);

/// The value below which the share p of all values lies, 0 < p < 1. Normal and lognormal (of the logarithm y): y = best + (high - best) z(p) / z(0.95) above best, with
/// best - low below it, z the quantile of the standard normal distribution; where min or max is given, p is the share of what is left between them.
Real quantile(const Distribution& distribution, Real p);

/// z with (1 + erf(z / sqrt 2)) / 2 = p, to 1e-14; at most 9 in size.
Real standard_normal_quantile(Real p);

}  // namespace berm::study
