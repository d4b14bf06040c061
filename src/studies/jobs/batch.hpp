// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"

namespace berm::jobs {

/// Runs that belong together, those of a study, say, and how each ended. A batch that is run again does what is left of it.
struct Batch {
  std::vector<Job> jobs = {};
  std::vector<std::string> names = {};  ///< of the jobs, for messages
  const char* what = "runs";            ///< the jobs in messages
  /// Whether a job has its result already.
  std::function<bool(const Job&)> has_result = has_ended_with_result;
  /// Called before the first run with the jobs that have their result and those to run; by default it tells how many have theirs.
  std::function<void(const std::vector<Job>& there, std::vector<Job>& to_run)> before = {};
  /// Called with a job of the batch and how it ended; by default it tells "3/7 NAME: 12 s", or why it failed.
  Ended ended = {};
  std::vector<JobEnd> ends = {};  ///< by job, once it was run

  std::size_t count(JobEnd::Kind kind) const;
  Outcome outcome() const;
};

/// Runs the jobs of a batch that have no result, those that can be resumed from their checkpoints. `queue`: as of run_jobs. Throws as run_jobs does.
void run_batch(Batch& batch, const Runner& runner, const std::filesystem::path& queue);

/// Tells what the same command does with jobs that were interrupted, or are queued.
void tell_of_rest(const Batch& batch);

}  // namespace berm::jobs
