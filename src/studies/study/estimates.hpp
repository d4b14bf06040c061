// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
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

/// What a sample tells of a measure, for one combination of all other axes. Numbers are those of the measure, NaN where they are not known.
struct Estimate {
  std::vector<std::string> names;  ///< the case, and the values of the other axes
  std::size_t measure;
  Real best;               ///< with all parameters at their medians
  Real low, middle, high;  ///< quantiles of 5, 50 and 95 % (sample_quantile)
  Real mean;
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

/// Spearman's rank correlation, from -1 to 1: the correlation of the places that the pairs have in order of x and in order of y; equal ones share their places.
/// NaN with fewer than three pairs or where x or y does not vary.
Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y);

}  // namespace berm::study
