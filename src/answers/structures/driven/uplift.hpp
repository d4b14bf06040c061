// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/travel_curve.hpp"
#include "structures/driven/results.hpp"

namespace berm::driven {

/// A lift by row, from the row before its first: how far up the body came, and R = -V, the force of the soil against it.
struct LiftPath {
  std::vector<Index> rows;      ///< of the history
  std::vector<Real> travel, R;  ///< m, N/m
  Real w_begin = nan;           ///< m
};

LiftPath lift_path(const OtherPush& lift, const run_folder::History& history);

/// What the soil has against a lift: its largest R, averaged as forces are. Empty where it never pulls the body down: it is unloaded only.
std::optional<UpliftResults> uplift_of(const OtherPush& lift, const run_folder::History& history, const BodyScale& scale);

}  // namespace berm::driven
