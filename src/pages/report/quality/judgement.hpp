// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/trust_measure.hpp"

namespace berm::report {

/// A measure that applies to a run, and what it gives.
struct JudgedMeasure {
  base::TrustMeasure measure;
  Real value;               ///< NaN: not known
  text::Standing standing;  ///< unknown where the value is not known; good where the measure is stated, not judged
};

/// What the page of a run says of it, all measures together.
struct Judgement {
  text::Standing standing;              ///< bad: the answer is invalid, or a measure is bad; fair: any other warning; good: none
  std::vector<JudgedMeasure> measures;  ///< those of the run's structure that apply
  std::vector<std::string> warnings;    ///< what is wrong with the run or not known of it, in sentences
};

Judgement judgement_of(const record::RunRecord& run);

/// The same of each run.
std::vector<Judgement> judgements_of(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
