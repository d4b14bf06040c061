// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/job.hpp"

namespace berm::verification {

/// How many jobs run and wait, and how long all of them will take, where `at_once` of them run at a time, the longest first. Times are in s since the first began.
class Remaining {
public:
  /// A job whose time is not known is taken to last as the others do on average. Where none is known seconds() is NaN.
  Remaining(const std::vector<jobs::Job>& jobs, int at_once);

  /// A job has ended, and the next one begins. The expected times of the others are scaled by what finished jobs took over what they were expected to.
  void end(std::size_t job, bool finished, Real now);

  std::size_t running() const;
  std::size_t waiting() const { return order_.size() - begun_; }
  /// Until the last one ends.
  Real seconds(Real now) const;

private:
  void begin_next(Real now);

  std::vector<std::size_t> order_;
  std::vector<Real> expected_, begin_;  ///< by job
  std::vector<bool> ended_;
  std::size_t at_once_, begun_ = 0;
  Real took_, was_expected_;
};

}  // namespace berm::verification
