// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::base {

/// A stage that ended by its time while what its forces move was still on its way: at its velocity it would go on by more than 2 % of its travel in another tenth of
/// the stage, and by more than a thousandth of its width.
struct StillMoving {
  std::string stage;
  std::string symbol;  ///< u, w; of a line y
  Real velocity;       ///< m/s, mean over the last part
  Real before, end;    ///< m, where it was as the last part began, and at the end
  Real last_part;      ///< s: since the ramp ended, a tenth of the stage at most
};

/// Those of a run, in the order of its stages: at most one for each, of what moves faster; none of stages that drive by a velocity or a displacement, or that end by anything but time.
std::vector<StillMoving> still_moving(const record::RunRecord& run);

/// "still moving at the end: y at 70 mm/s, from 2.55 m to 2.74 m in the last 1 s".
std::string still_moving_words(const StillMoving& moving);

/// A line for each such stage, for the log behind the key results; "" without any.
std::string still_moving_lines(const record::RunRecord& run);

}  // namespace berm::base
