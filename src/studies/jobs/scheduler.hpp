// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"

#include <memory>

namespace berm::jobs {

/// Who works on a queue. A handle is what it is known by, also in a later command: its first word names the kind.
class Scheduler {
public:
  virtual ~Scheduler() = default;
  /// Hands over the `count` jobs that lie in the queue's folder. Throws RunError where they are refused.
  virtual std::string submit(const std::filesystem::path& queue, std::size_t count) = 0;
  /// Whether it works, or may work, on what it was handed. Throws RunError where the handle is another kind's.
  virtual bool works_on(const std::string& handle) = 0;
  /// After Ctrl-C: stops what would not outlive this program, and says what becomes of the rest.
  virtual void leave(const std::string& handle) = 0;
  /// Why none of the jobs may have begun; "" where nothing is wrong.
  virtual std::string complaint() { return ""; }
  /// How long to wait before it is asked again, s, where it has worked for `waited` s.
  virtual Real pause(Real waited) const = 0;
};

std::unique_ptr<Scheduler> scheduler_for(const ShellCommand& command, bool wait);
std::unique_ptr<Scheduler> scheduler_for(const Slurm& slurm);

}  // namespace berm::jobs
