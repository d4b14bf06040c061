// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/outcome.hpp"
#include "simulation/simulate.hpp"

namespace berm::commands {

/// Runs cases at the same time, each by a process of its own on one thread, `at_once` of them at a time, and prints the run.log of each as it ends:
/// for finite elements, which hardly gain by threads. `overrides` are those that the requests were read with.
jobs::Outcome run_side_by_side(const std::vector<simulation::RunRequest>& requests, const std::vector<std::string>& overrides, int at_once);

}  // namespace berm::commands
