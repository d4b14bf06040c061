// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::springs {

/// A lognormal distribution fitted to a sample: mean and standard deviation of the logarithms (n - 1 below the sum).
struct Lognormal {
  Real mean = nan, deviation = nan;
  /// Largest distance between the fitted distribution and that of the sample (Kolmogorov and Smirnov), times sqrt(n) - 0.01 + 0.85/sqrt(n): the sample's own mean and
  /// deviation are taken for it, so that 5 of 100 samples of a lognormal quantity exceed lognormal_limit (Stephens 1974).
  Real distance = nan;

  /// Whether the sample does not speak against it.
  bool fits() const;
  /// The value below which the share p lies.
  Real quantile(Real p) const;
};
constexpr Real lognormal_limit = 0.895;

/// NaN where there are fewer than five values, one of them is not greater than 0, or all are equal but for a thousandth.
Lognormal fit_lognormal(std::vector<Real> values);

}  // namespace berm::springs
