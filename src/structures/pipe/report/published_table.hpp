// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// What design codes and published formulas give beside the runs, as HTML with its heading: of each run remarks, then a table with its states as groups. Of
/// several runs each can be folded away; the first stands open. "" where there is none.
std::string published_values(const PipeRuns& runs, const base::DisplayUnits& shown);

}  // namespace berm::pipe
