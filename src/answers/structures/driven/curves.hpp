// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/base/chart.hpp"
#include "structures/base/driven_body.hpp"

namespace berm::driven {

/// curves.png of run_charts: V(w) of the push, H(u) and w(u) of the drag (as far as there are both), with dimensionless axes beside. Thin: every row; thick:
/// freed from noise over +-0.01 D, of several drags from light to dark; filled: `bands` (run_folder::CurveBand). False, with a warning, where
/// it could not be drawn.
bool draw_run_curves(const run_folder::RunFolder& folder, const base::Charts& charts, const base::BodyScale& scale,
                     const std::string& title, const std::vector<run_folder::CurveBand>& bands);

}  // namespace berm::driven
