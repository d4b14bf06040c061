// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/published_point.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// Draws V(w), H(u), w(u) and H/V of all runs over one another, with what is published, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_curves(const PipeRuns& runs, const base::PublishedPoints& published, const std::filesystem::path& folder);

}  // namespace berm::pipe
