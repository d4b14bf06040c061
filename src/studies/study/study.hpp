// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"
#include "study/study_settings.hpp"

namespace berm::study {

/// One run of a study: a row of its table.
struct StudyRow {
  std::vector<std::size_t> choice;  ///< which case, then which value of each axis
  std::vector<std::string> names;   ///< of the same
  Real diameter = 0;                ///< m, of the main rigid body; 0 = it is no circle
  jobs::Job job;
  jobs::JobEnd end;
  std::vector<Real> numbers;  ///< by measure, scaled; NaN where there is none
};

/// A combination that is left out.
struct SkippedRow {
  std::vector<std::string> names;
  std::string why;
};

/// All runs of a study, in the order of the table: the last axis changes fastest.
struct StudyPlan {
  Study study;
  std::vector<StudyRow> rows;
  std::vector<SkippedRow> skipped;
};

/// Reads a study and all its cases with all changes; run folders are OUTPUT/runs/CASE.VALUE.VALUE... Throws InputError where a file, a change or
/// a case is wrong.
StudyPlan plan_study(const std::filesystem::path& file, const std::filesystem::path& output);

/// Runs what has no result yet, by the runner and its folder OUTPUT/queue, and writes OUTPUT/results.csv, results.md and a picture for each figure. A run whose folder
/// holds a finished result of the same resolved case by the same version and engine of berm is not run again. A run that fails is a row that says so.
/// Unfinished where Ctrl-C ended it or
/// runs are still queued; the same goes on from there. Throws RunError.
jobs::Outcome run_study(StudyPlan& plan, const std::filesystem::path& output, const jobs::Runner& runner);

}  // namespace berm::study
