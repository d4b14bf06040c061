// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/job.hpp"

#include <optional>

namespace berm::jobs {

/// A folder by which jobs are handed to another program, and their ends are found later. It holds
///   jobs       what was handed over last, one shell command a line
///   run_job    what each of these commands starts: berm run, or berm run --resume where the job has begun before; notes in FOLDER.status how it failed or was stopped
///   open       to whom (the handle), and below it the command of each job that it has been asked for; there until all of them have ended
/// The truth is in the run folders: a job that ended well has its result there, and one that was stopped its checkpoint.
class Queue {
public:
  /// Reads what an earlier command left there. All paths in it are absolute. The jobs must outlive it.
  Queue(const std::filesystem::path& folder, const std::vector<Job>& jobs);

  const std::filesystem::path& folder() const { return folder_; }
  /// Who works on it: "slurm 12"; "" nobody.
  const std::string& handle() const { return handle_; }
  /// Throws RunError where a job is not among those that were handed over.
  void check_holds_all() const;
  /// The jobs that have not ended, the longest first.
  std::vector<std::size_t> to_do() const;
  /// Writes all files for these. Removes what lies in the folder of a job that is to begin anew and could be taken for its own.
  void write(const std::vector<std::size_t>& jobs);
  /// Notes who works on it now.
  void hand_to(const std::string& handle);
  /// How a job has ended; empty where it is not known to have, or was stopped and may yet go on.
  std::optional<JobEnd> end_of(std::size_t job) const;
  /// Whether no job has left a sign of itself.
  bool none_has_begun() const;
  /// How it ended where nobody works on it any more.
  JobEnd left_over(std::size_t job) const;
  /// All jobs have ended: the next command begins anew.
  void close();

private:
  bool was_handed_over(std::size_t job) const;
  std::optional<int> status_of_job(std::size_t job) const;

  std::filesystem::path folder_;
  const std::vector<Job>& jobs_;
  std::vector<std::string> lines_;  ///< by job
  std::string handle_;
  std::vector<std::string> handed_over_;
};

}  // namespace berm::jobs
