// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "record/run_record.hpp"
#include "run_folder/uncertainty.hpp"
#include "settings/case.hpp"

#include <optional>
#include <vector>

namespace berm::uncertainty {

/// A finished run that a band is made of.
struct VariantRecord {
  Real size, speed;  ///< as in Variant
  record::RunRecord run;
  std::optional<Real> d50 = {};  ///< as in Variant
};

/// The bands of all answers of a run's structure and of its curves, from the run and those with coarser cells; at another speed than 1 only one of the size of the
/// coarsest, and none with grains. A number or curve that a coarser run has not, and a number that noise makes or hides, have no band, and `without` says so.
run_folder::Uncertainty bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants);

/// All answers of a run's structure with grains beside those without, of runs on cells of one size. `variants` are all that were run.
run_folder::Grains grains_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants);

/// What a run's numbers are uncertain by as means over noisy rows, at 95 %, in the order of its quantities: twice the standard error of the jackknife over five sets of
/// rows, each every fifth row. 0 for methods without noise and for numbers that are not of the rows; NaN where a number is found without some of the rows and not without others.
std::vector<Real> noise_of(const record::RunRecord& run);

/// The bands as a table for people: the run's number, the converged one with its half width, and the parts of that; below it what has no band, and why.
std::string words_of(const run_folder::Uncertainty& uncertainty, settings::Method method);

/// A number that a run with other cells gave.
struct SizedNumber {
  Real size;  ///< of its cells, over that of the finest run
  Real number;
};

/// What numbers of several sizes of cells tell of the number for cells without size.
struct Estimate {
  Real converged;      ///< where the line comes to size 0
  Real extrapolation;  ///< half of the way from the line at size 1 to there
  Real mesh;           ///< 95 % of Student's distribution for `converged` as a constant of the fitted line
};

/// The least-squares line number = converged + slope size, each weighted by 1 / size^2: numbers scatter from mesh to mesh in proportion to the cells. Needs three
/// numbers of two sizes at least; NaN where one of them is NaN. Source: docs/theory/method.md, Discretisation uncertainty.
Estimate extrapolate(const std::vector<SizedNumber>& numbers);

/// The half width of a band of 95 % in standard deviations that were found from so many numbers more than were fitted.
Real student_95(int degrees_of_freedom);

/// The part of converged +- half_width that comes from all: what the extrapolation is uncertain by stands, for it is no accident; the others are independent.
Real half_width(Real extrapolation, Real mesh, Real noise, Real speed);

}  // namespace berm::uncertainty
