// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/study.hpp"

namespace berm::study {

/// Writes OUTPUT/results.csv (all digits), results.md (a table for people, with what was skipped and what failed, and the figures) and a picture
/// for each figure. Throws RunError.
void write_study_report(const StudyPlan& plan, const std::filesystem::path& output);

}  // namespace berm::study
