// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/test_run.hpp"

namespace berm::report {

/// What a claim may be about: numbers that a run with a pipe gives. Lengths are in D, areas in D2, forces in N/m; u is counted from the begin of the drag.
enum class ClaimObservable {
  V_at_w,     ///< of the push
  w_at_V,     ///< where V of the push first reaches a force
  w_of_push,  ///< in the last frame of the push
  H_at_u,     ///< of the drag
  V_at_u,
  w_at_u,
  H_at_w,  ///< of the drag, where w first reaches a depth
  V_in_drag_at_w,
  u_at_w,
  H_at_part,  ///< at a part of the drag: 1 is its end
  V_at_part,
  u_at_part,
  prototype_H_at_part,  ///< in the prototype
  w_at_begin,           ///< where the drag begins
  sinking_at_u,         ///< w less that at the begin of the drag
  sinking_after_u,      ///< w at the end of the drag less that at u
  heave_behind,         ///< rise of the surface beside the pipe at the end of the push
  heave_ahead,
  spread_heave,       ///< rise that the displaced soil would make, spread evenly over 1.5 D to both sides of the axis
  heave_over_spread,  ///< the smaller of the two over that
  berm_at_u,          ///< area of the soil above the surface ahead, in the frame nearest to u
  berm_at_end,
  sheared_behind,  ///< part of the shearing behind the pipe's centre, between two frames of the drag: where w is nearest to a depth, else the last
  shearing_reach,  ///< distance ahead within which nine tenths of the rest lie
  dragged,         ///< part of the heaped soil that moves along
  w_of_frame,      ///< embedment in that frame
  quantity         ///< of summary.json
};

/// How an observable is measured, and where.
enum class ClaimUnit { length, area, force, number, none };
struct ObservableKind {
  const char* word;
  ClaimUnit unit, at;
  bool needs_at;
};
const ObservableKind& kind_of(ClaimObservable observable);
const std::vector<const char*>& observable_words();

/// The SI unit of what is measured: lengths are bare numbers, of D.
const char* unit_of(ClaimUnit unit);

/// A number as sentences have it: "0.25 D", "1.2 kN/m".
std::string words_of(ClaimUnit unit, Real value);

/// The number that a run gives; NaN where it has none. Throws RunError where a frame is damaged.
Real evaluate(ClaimObservable observable, std::optional<Real> at, const std::string& quantity, const TestRun& run);

}  // namespace berm::report
