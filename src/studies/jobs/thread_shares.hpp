// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

#include <map>
#include <vector>

namespace berm::jobs {

/// Most threads that a run of this case is worth: of finite elements one, else one for each 10 000 particles, counted before there is a mesh; one where that cannot be.
int threads_worth(const settings::Case& settings);

/// Shares processors out among jobs that run side by side: one each while as many wait, more each for the last ones, the first of them most. A job that has begun keeps
/// what it has.
class ThreadShares {
public:
  /// As many jobs at a time at most, on these processors.
  ThreadShares(int at_once, std::vector<int> processors);

  bool any_free() const { return taken_ < at_once_; }
  /// Threads for the next of `left` jobs that have not begun.
  int for_next(std::size_t left) const;
  /// Gives a job so many, and processors that are no other's where it has several; none where there are not enough.
  std::vector<int> begin(std::size_t job, int threads);
  void end(std::size_t job);

private:
  struct Share {
    int threads;
    std::vector<int> processors;
  };
  int at_once_, taken_ = 0, most_;
  std::vector<int> free_;  ///< processors that are not given away
  std::map<std::size_t, Share> shares_;
};

}  // namespace berm::jobs
