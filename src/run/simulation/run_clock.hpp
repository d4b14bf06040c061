// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "core/timer.hpp"

namespace berm::simulation {

/// The wall time of a run and the time by loop, those of earlier programs included where the run is resumed. Begins, with an empty table of timings, when it is made.
class RunClock {
public:
  explicit RunClock(Timings& timings) : timings_(timings) { timings.clear(); }

  Real earlier() const { return earlier_; }  ///< s
  Real wall() const { return earlier_ + std::chrono::duration<Real>(std::chrono::steady_clock::now() - start_).count(); }
  std::vector<Timing> loops() const;

  void archive(Archive& k);

private:
  Timings& timings_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Real earlier_ = 0;
  std::vector<Timing> earlier_loops_;
};

}  // namespace berm::simulation
