// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "jobs/outcome.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace berm::jobs {

/// One run of a case by a process of its own, on one thread.
struct Job {
  std::filesystem::path case_file;
  std::vector<std::string> set;  ///< overrides KEY=VALUE
  std::filesystem::path folder;  ///< the run folder
  bool fast = false;             ///< expected to take a few seconds, where no earlier run tells its time
  bool uncertainty = false;      ///< with the bands of its results (berm run --uncertainty)
  bool element = false;          ///< element tests (berm element) instead of a run
  bool resume = false;           ///< from its last checkpoint (berm run --resume), where it goes_on
};

/// Runs the jobs, at_once of them at a time, each by this program with --threads 1, and calls `ended` in this thread as each
/// ends. The longest starts first, by the wall time in summary.json of an earlier run in the same folder; jobs without one
/// come before them. The output of a process goes to FOLDER.messages, which is removed where the run finishes. Ctrl-C
/// (catch_interrupts) stops the running ones, waits for them and starts no more; `ended` is called for each job all the
/// same. Throws RunError where no process can be started at all.
void run_jobs(const std::vector<Job>& jobs, int at_once, const std::function<void(std::size_t job, const JobEnd& end)>& ended);

/// Whether the run folder holds a finished result of this case by this build of berm (run_folder::by_this_build).
bool has_result(const Job& job);

/// Whether the run folder holds a run of this case by this build that ended on the way and left what `berm run --resume` goes on from.
bool goes_on(const Job& job);

/// Wall time of the run in this folder, s, from its summary.json; NaN where there is none.
Real wall_time_of(const std::filesystem::path& folder);

}  // namespace berm::jobs
