// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::study {

/// The value below which the share p of a population lies, as its sample tells: the k-th of n values in order stands for p = (k - 1/2) / n, and between
/// two it is linear (Hazen; type 5 of Hyndman and Fan, 1996). NaN where p lies beyond the first or the last value: 5 and 95 % need ten.
Real sample_quantile(std::vector<Real> values, Real p);

/// NaN without values.
Real mean_of(const std::vector<Real>& values);

/// Spearman's rank correlation, from -1 to 1: the correlation of the places that the pairs have in order of x and in order of y; equal ones share their places.
/// NaN with fewer than three pairs or where x or y does not vary.
Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y);

}  // namespace berm::study
