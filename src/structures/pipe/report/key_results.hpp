// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// The key results of all runs that have a pipe, as HTML tables: V of the push by embedment, H and w of the drag by displacement, and the resistance to the
/// drag (largest H, breakout, residual H). Of several runs the same point stands one below the other. "" where there is none.
std::string key_results(const PipeRuns& runs, const base::DisplayUnits& shown);

}  // namespace berm::pipe
