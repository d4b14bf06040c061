// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/summary.hpp"

namespace berm::pipe {

/// Moments of the soil on the driven body in space about its centre, N m, averaged as V is: Mx_end_of_push, ... at the end of the way down, Mx_end_of_drag, ... at that of
/// the first drag. Components below a thousandth of V D (H D) are noise and left out; in the plane and around an axis there are none.
std::vector<run_folder::Quantity> moments_in_space(const record::RunRecord& run);

}  // namespace berm::pipe
