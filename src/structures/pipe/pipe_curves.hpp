// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/pipe/results/pipe_quantities.hpp"

namespace berm::pipe {

/// curves.png: V(w) of the push, H(u) and w(u) of the drag (as far as there are both), with dimensionless axes beside. Thin: every row; thick:
/// freed from noise over +-0.01 D. False, with a warning, where it could not be drawn.
bool draw_pipe_curves(const run_folder::RunFolder& folder, const run_folder::History& history, const BodyScale& scale,
                      const PipeStages& stages, const std::string& title);

}  // namespace berm::pipe
