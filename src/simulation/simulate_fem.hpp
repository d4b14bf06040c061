// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/simulate.hpp"

namespace berm::simulation {

/// What run_case, try_to_build and check_case do for method = "fem".
bool run_fem(const RunRequest& request);
void try_to_build_fem(const RunRequest& request);
void check_fem(const RunRequest& request);

}  // namespace berm::simulation
