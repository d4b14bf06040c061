// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/formulas/pipe_in_clay.hpp"
#include "structures/formulas/pipe_in_sand.hpp"

// Lateral resistance and initial embedment of pipes by DNV-RP-F109, on-bottom stability. The embedment in sand is sand_embedment.

namespace berm::formulas {

/// The largest horizontal resistance in sand under a vertical load V, N/m, against the motion: with k = gamma' D^2/V
/// H = 0.6 V + V (5 k - 0.15 k^2) (w/D)^1.25 for k <= 20, else 0.6 V + V 2 k (w/D)^1.25. [fit: DNV-RP-F109]
Formula f109_sand_lateral(const PipeInSand& pipe, Real V);

/// The same in clay: H = 0.2 V + 4.1 D s_u G^-0.39 (w/D)^1.31, G = s_u/(gamma' D). [recalled: DNV-RP-F109; Verley and Lund 1995]
Formula f109_clay_lateral(const PipeInClay& pipe, Real V);

/// The embedment in clay under a vertical load V (N/m), m: with G = s_u/(gamma' D) and x = G^0.3 V/(D s_u), w = D (0.0071 x^3.2 + 0.062 x^0.7); the pipe's own
/// embedment is not used. [recalled: DNV-RP-F109; Verley and Lund 1995]
Formula f109_clay_embedment(const PipeInClay& pipe, Real V);

}  // namespace berm::formulas
