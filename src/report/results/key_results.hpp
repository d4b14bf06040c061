// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/display_units.hpp"

namespace berm::report {

/// The key results of all runs that have a pipe, as HTML tables: V of the push by embedment, H and w of the drag by displacement, and the resistance to the
/// drag (largest H, breakout, residual H). Of several runs the same point stands one below the other. "" where there is none.
std::string key_results(const std::vector<pipe::RunRecord>& runs, const pipe::DisplayUnits& shown);

}  // namespace berm::report
