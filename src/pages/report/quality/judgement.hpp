// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// What the page of a run says of it, all measures together.
struct Judgement {
  text::Standing standing;            ///< bad: the answer is spoiled, or a measure is bad; fair: any other warning; good: none
  std::vector<std::string> warnings;  ///< what is wrong with the run or not known of it, in sentences
};

Judgement judgement_of(const record::RunRecord& run);

}  // namespace berm::report
