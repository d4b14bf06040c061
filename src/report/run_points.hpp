// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/run_record.hpp"

#include <optional>

namespace berm {

/// A point of a push.
struct PushPoint {
  Real w, V;  ///< m, N/m
};

/// A point of a drag; u counts from where it began.
struct DragPoint {
  Real u, w, H, V;  ///< m, m, N/m, N/m
};

/// What the quantities of a run tell of its pipe's path, as far as it came.
struct RunPoints {
  Real first_w = 0;             ///< m, before the first stage: 0 or less where the pipe begins above the soil; NaN without a history
  std::vector<PushPoint> push;  ///< by growing w
  std::optional<PushPoint> push_end;
  std::vector<DragPoint> drag;         ///< by growing u
  std::optional<DragPoint> largest_H;  ///< u and H only
};

RunPoints points_of(const RunRecord& run);

/// Whether the pipe lay in the soil from the start, below a flat surface: deeper than 0.01 D.
bool is_wished_in_place(const RunRecord& run);

}  // namespace berm
