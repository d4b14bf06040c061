// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/driven_run.hpp"

#include <optional>

namespace berm::driven {

/// What the results of a run tell of its pipe's path, as far as it came.
struct RunPoints {
  Real first_w = 0;                   ///< m, before the first stage: 0 or less where the pipe begins above the soil
  std::vector<PushPoint> push;        ///< by growing w; none closer than same_point to where the push begins or ends
  std::optional<PushPoint> push_end;  ///< or where the run was stopped in it
  std::vector<DragPoint> drag;        ///< by growing u
};

/// Points closer than this (over D) tell the same: the begin of a push has no strength yet, and its end stands for the points beside it.
constexpr Real same_point = 0.01;

RunPoints points_of(const DrivenRun& run);

/// Where a push or a drag of a run ended: "to the end of the push", and where the run did not finish it "to where it was stopped" or, of a run that was
/// killed or still runs, "as far as it came".
struct StageEnd {
  bool reached;
  std::string to, at;  ///< "to the end of the push", "end of the push"
};
StageEnd end_of_push(const DrivenRun& run);
StageEnd end_of_drag(const DrivenRun& run);

/// Whether the pipe lay in the soil from the start, below a flat surface: deeper than 0.01 D.
bool starts_embedded(const DrivenRun& run);

}  // namespace berm::driven
