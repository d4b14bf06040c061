// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/job.hpp"

#include <functional>
#include <variant>

namespace berm::jobs {

/// Runs jobs on this machine.
struct LocalProcesses {
  int at_once = 1;  ///< jobs at a time
};

/// Hands jobs to a shell command, which contains {jobs}, the file of one command a line, and may contain {count}, the number of its lines.
struct ShellCommand {
  std::string command;
};

/// Hands jobs to Slurm, as one job array.
struct Slurm {
  std::string options;  ///< of sbatch, as a shell reads them
  int pack = 1;         ///< jobs a task
  int at_once = 0;      ///< tasks at a time; 0: as many as Slurm starts
};

/// What runs jobs.
struct Runner {
  std::variant<LocalProcesses, ShellCommand, Slurm> by;
  bool wait = true;  ///< until they have ended; false: they are handed over, and the same command collects them later
};

/// What is called with each job and how it ended.
using Ended = std::function<void(std::size_t job, const JobEnd& end)>;

/// Throws InputError where the runner cannot work: a command without {jobs}, no sbatch on this machine.
void check_runner(const Runner& runner);

/// Whether an earlier command handed runs over by that queue that were not collected yet.
bool handed_over(const std::filesystem::path& queue);

/// Runs the jobs, each by this program on one thread, the last local ones on what processors are left (ThreadShares), and calls `ended` in this thread as each ends; by_time says which starts first. The output of a
/// job goes to FOLDER.messages, which is removed where it finishes. Ctrl-C (catch_interrupts) stops local processes and a command that is still
/// at work, waits for them and starts no more; what a scheduler was given stays there. `ended` is called for each job all the same.
///
/// A runner that is not local leaves the folder `queue` (queue.hpp), by which the same call collects what an earlier one handed over, or hands over
/// again what did not end. Throws RunError where no job can be started at all, or where the queue holds other jobs that are still at work.
void run_jobs(const std::vector<Job>& jobs, const Runner& runner, const std::filesystem::path& queue, const Ended& ended);

}  // namespace berm::jobs
