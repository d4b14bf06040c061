// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "core/timer.hpp"
#include "run_folder/summary.hpp"

namespace berm::simulation {

/// The wall time of a run, what of it its parts take, the time of processors, and the time by loop, those of earlier programs included where the run is resumed. Begins, with an
/// empty table of timings, when it is made.
class RunClock {
public:
  explicit RunClock(Timings& timings) : timings_(timings) { timings.clear(); }

  /// Adds its life to a part.
  class In {
  public:
    explicit In(Real& part) : part_(part) {}
    ~In() { part_ += std::chrono::duration<Real>(std::chrono::steady_clock::now() - start_).count(); }
    In(const In&) = delete;
    In& operator=(const In&) = delete;

  private:
    Real& part_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };
  run_folder::TimeOfParts& parts() { return parts_; }

  Real earlier() const { return earlier_; }  ///< s
  Real wall() const { return earlier_ + std::chrono::duration<Real>(std::chrono::steady_clock::now() - start_).count(); }
  Real processors() const { return earlier_processors_ + processors_now() - processors_at_start_; }
  std::vector<Timing> loops() const;

  void archive(Archive& k);

private:
  Timings& timings_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  static Real processors_now();

  Real earlier_ = 0, earlier_processors_ = 0, processors_at_start_ = processors_now();
  run_folder::TimeOfParts parts_;
  std::vector<Timing> earlier_loops_;
};

}  // namespace berm::simulation
