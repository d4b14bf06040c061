// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// What pipes in soil with water could carry along their axis by friction at the ends of stages, beside the published wedging factor, as an HTML table; "" where no run has it.
std::string axial_table(const PipeRuns& runs, const base::DisplayUnits& shown);

}  // namespace berm::pipe
