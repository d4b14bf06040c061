// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/after_run.hpp"
#include "simulation/simulate.hpp"

namespace berm::after_run {

/// What berm makes of every run: the answers of its structure, its curves as numbers and drawn, tables by depth and pictures of the soil.
simulation::AfterRun answers_and_drawings();

/// The key results of a finished run in its folder, as a table under the name of the folder; "" where there are none.
std::string key_results_in(const simulation::RunRequest& request);

}  // namespace berm::after_run
