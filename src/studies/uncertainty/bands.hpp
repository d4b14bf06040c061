// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::uncertainty {

/// A finished run that a band is made of.
struct VariantRecord {
  Real size, speed;  ///< as in Variant
  record::RunRecord run;
};

/// The bands of all answers of a run's structure and of its curves, from the run and those with coarser cells; at another speed than 1 only one of the size of the
/// coarsest. A number or curve that a coarser run has not, and a number that noise makes or hides, have no band, and `without` says so.
run_folder::Uncertainty bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants);

/// What a run's numbers are uncertain by as means over noisy rows, at 95 %, in the order of its quantities: twice the standard error of the jackknife over five sets of
/// rows, each every fifth row. 0 for methods without noise and for numbers that are not of the rows; NaN where a number is found without some of the rows and not without others.
std::vector<Real> noise_of(const record::RunRecord& run);

}  // namespace berm::uncertainty
