// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "run_folder/run_log.hpp"

#include <chrono>
#include <string>

namespace berm::run_folder {

/// How far a run is. NaN: not known, or there is no rigid body; it is left out of the line then.
struct ProgressReport {
  std::string stage;
  Real done = nan;          ///< of the whole run, 0 ... 1
  bool drag = false;        ///< show u beside w
  Real u = nan;             ///< m, from the begin of the drag
  Real w = u;               ///< m
  Real V = u, H = u;        ///< N/m, or whole in N
  bool whole = false;       ///< V and H are in N
  Real diameter = 0;        ///< m; 0: u is shown in mm
  Real particle_steps = 0;  ///< since the start
};

/// One line that says how far the run is, what matters most first (a narrow terminal cuts it): stage, part done, the time left if the run goes
/// on as since its start, u and w, V and H, speed.
std::string progress_line(const ProgressReport& report, Real seconds_since_start);

/// Tells how far a run is: on a terminal in one line that is rewritten at most five times a second; else, and in the run's log always, in a plain
/// line at the start of each stage, every tenth of the run and every 30 s.
class Progress {
public:
  explicit Progress(RunLog& log);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// True where an update would show something by its time; asking costs about 30 ns, so that a step loop may ask every time.
  bool due() const;
  void update(const ProgressReport& report);
  /// The run was begun by earlier programs, which took that many seconds of wall time.
  void count_from(Real seconds_before);

private:
  using Clock = std::chrono::steady_clock;

  RunLog& log_;
  Clock::time_point start_, shown_, told_;
  int tenth_ = 0;
  std::string stage_;
};

}  // namespace berm::run_folder
