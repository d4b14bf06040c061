// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// What a run's pipe did and met, in a few sentences, HTML without the run's name.
std::string results_in_words(const PipeRun& run, const base::DisplayUnits& shown);

}  // namespace berm::pipe
