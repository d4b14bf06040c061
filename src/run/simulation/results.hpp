// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/simulate.hpp"

namespace berm::simulation {

/// Writes summary.json and what else is made of a run (AfterRun), and logs the time by loop. Returns its key results as a table, "" where there is none. `warnings`: what was doubtful of the
/// case before it ran.
std::string write_results(const RunRequest& request, EndedRun ended, const AfterRun& after, const std::vector<std::string>& warnings,
                          const run_folder::RunTiming& timing);

}  // namespace berm::simulation
