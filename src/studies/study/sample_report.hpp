// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/study.hpp"

namespace berm::study {

/// Writes what the sample of a study tells: OUTPUT/estimates.csv, sensitivity.csv and a tornado picture for each measure and combination of the other axes. Returns the same as Markdown, with
/// the pictures; "" of a study without a sample. Throws RunError.
std::string write_sample_report(const StudyPlan& plan, const std::filesystem::path& output);

}  // namespace berm::study
