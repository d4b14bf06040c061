// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/measured.hpp"

#include <Eigen/Core>

namespace berm::soil_fit {

/// A free key as it was found.
struct FittedKey {
  FreeKey free;
  Real start = nan, value = nan, error = nan;  ///< SI; the standard error, infinite where the tests do not tell the key
  bool at_bound = false;
};

/// A direction of the free keys in which the tests change least: what a step of one standard error along it does to each key, as place_of.
struct FlatDirection {
  std::vector<Real> step;  ///< by key
};

/// A test beside what the law makes of it.
struct FittedTest {
  MeasuredTest measured;
  std::vector<std::vector<Real>> computed;  ///< as MeasuredTest::curves
  std::vector<Real> rms;                    ///< by curve: root mean square of computed less measured, SI
  std::vector<Real> largest;                ///< by curve: largest size of what was measured, SI
  bool complete = true;                     ///< whether the law has states for all of it
};

struct FittedSoil {
  std::vector<FittedKey> keys;
  Eigen::MatrixXd correlation;  ///< of the keys that are not at a bound; 0 elsewhere, 1 on its diagonal
  std::vector<FlatDirection> flat;
  std::vector<FittedTest> tests;
  Real misfit_at_start = nan, misfit = nan;  ///< root of the mean square over all curves that are fitted, over the largest of each
  std::vector<Real> misfits;                 ///< that each start ended at, the least first
  int evaluations = 0;                       ///< of all tests
};

/// The values of the free keys at which the sum of squares is least: of each curve the mean of ((computed - measured) / largest)^2, times the weight of its test (Levenberg and
/// Marquardt's method, within the bounds by a transformation, from several starts). Standard errors are those of least squares whose rows scatter by their own residuals, and together as far
/// as those are correlated along a curve. Throws RunError where no start has a test that the law can follow.
FittedSoil fit_soil(const FitCase& c, const std::vector<MeasuredTest>& tests);

}  // namespace berm::soil_fit
