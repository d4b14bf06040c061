// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// Draws the soil at the end of each run and its mechanism there, and that of the material point method once more at the embedment of finite elements: SVG and
/// PNG. Gives the names of what was drawn.
std::vector<std::string> draw_soil_figures(const PipeRuns& runs, const std::filesystem::path& folder);

}  // namespace berm::pipe
