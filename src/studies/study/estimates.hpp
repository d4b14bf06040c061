// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "study/rank_correlation.hpp"
#include "study/study.hpp"

#include <vector>

namespace berm::study {

/// What one parameter of a sample does to a measure.
struct Swing {
  std::size_t parameter;  ///< of the axis of the sample
  Real low,
      high;  ///< the measure with this parameter at its 5 % and at its 95 % value, all others at their medians; NaN where there are no such runs
  Real correlation;  ///< rank correlation of parameter and measure over the sample
  Real width() const { return std::abs(high - low); }
};

/// How the numbers of a sample scatter; NaN where it is not known.
struct Spread {
  Real deviation = nan;                      ///< standard deviation, by n - 1
  Real log_mean = nan, log_deviation = nan;  ///< of the logarithm, of numbers that are all positive: the lognormal distribution
  Real below = nan;                          ///< part of the numbers that lie below a limit
  Real below_error = nan;                    ///< its standard error, sqrt(p (1 - p)/n) with p = (k + 1)/(n + 2) of k below it
  Real below_by_lognormal = nan;             ///< the same by the lognormal distribution
};

/// What a sample tells of a measure, for one combination of all other axes. Numbers are those of the measure, NaN where they are not known.
struct Estimate {
  std::vector<std::string> names;  ///< the case, and the values of the other axes
  std::size_t measure;
  Real best;               ///< with all parameters at their medians
  Real low, middle, high;  ///< quantiles of 5, 50 and 95 % (sample_quantile)
  Real mean;
  Spread spread = {};
  std::size_t numbers = 0, failed = 0;  ///< rows of the sample that have a number, and runs of it that failed
  std::vector<Swing> swing;             ///< the widest first, of the unknown the largest correlation
};

/// By combination, then measure, in the order of the rows; empty without a sample.
std::vector<Estimate> estimates_of(const StudyPlan& plan);

/// Whether a measure is taken of a row: it is of its cases.
bool is_wanted(const StudyMeasure& measure, const StudyRow& row);

/// Warns of a sample that is too small.
void warn_of_small_sample(const std::filesystem::path& file, const Study& study);

/// The value below which the share p of a population lies, as its sample tells: the k-th of n values in order stands for p = (k - 1/2) / n, and between
/// two it is linear (Hazen; type 5 of Hyndman and Fan, 1996). NaN where p lies beyond the first or the last value: 5 and 95 % need ten.
Real sample_quantile(std::vector<Real> values, Real p);

/// NaN without values.
Real mean_of(const std::vector<Real>& values);

/// The spread of these numbers, with the probability that one lies below the limit, if there is one.
Spread spread_of(const std::vector<Real>& numbers, const std::optional<Real>& limit);

}  // namespace berm::study
