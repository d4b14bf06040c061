// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/context.hpp"

#include <string>
#include <vector>

namespace berm::bench {

/// The fixed problems that bench_steps knows.
std::vector<std::string> problem_names();

/// Steps the named problems (none named: all) for `seconds` each and the bare kernel on their particles, prints a table of particle-steps per second and time by
/// loop, and writes the same as JSON to json_file unless that is empty. Throws RunError.
void measure_steps(const std::vector<std::string>& names, const std::string& json_file, simulation::Context& context, Real seconds = 3);

}  // namespace berm::bench
