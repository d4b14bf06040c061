// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

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
  bool fast = false;             ///< a few seconds, where nothing better is known
};

/// How a job ended.
struct JobEnd {
  enum class Kind { finished, failed, interrupted };
  Kind kind = Kind::interrupted;
  std::string reason;  ///< why it failed: its last message, or the signal that ended it
};

/// Runs the jobs, at_once of them at a time, each by this program with --threads 1, and calls `ended` in this thread as they end. The longest begin
/// first: by the time that summary.json of an earlier run in the same folder tells; those that tell none before them. What a process says goes to
/// FOLDER.messages, which is removed where the run finishes. Ctrl-C (catch_interrupts) asks those that run to stop, waits for them and starts no
/// more; `ended` is called for each job all the same. Throws RunError where no process can be started at all.
void run_jobs(const std::vector<Job>& jobs, int at_once, const std::function<void(std::size_t job, const JobEnd& end)>& ended);

/// Whether the run folder holds a finished result of this very case, by this version and an engine that has not changed since.
bool has_result(const Job& job);

/// s that the run in this folder took, as its summary.json tells; NaN where there is none.
Real wall_time_of(const std::filesystem::path& folder);

}  // namespace berm::jobs
