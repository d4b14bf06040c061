// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/formulas/pipe_in_sand.hpp"

// Lateral resistance of pipes in sand by DNV-RP-F109, on-bottom stability. The embedment in sand is sand_embedment.

namespace berm::formulas {

/// The largest horizontal resistance in sand under a vertical load V, N/m, against the motion: with k = gamma' D^2/V
/// H = 0.6 V + V (5 k - 0.15 k^2) (w/D)^1.25 for k <= 20, else 0.6 V + V 2 k (w/D)^1.25. [fit: DNV-RP-F109]
Formula f109_sand_lateral(const PipeInSand& pipe, Real V);

}  // namespace berm::formulas
