// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/formulas/pipe_in_clay.hpp"

// What a pipe meets that is swept over clay, once or many times; the strength is that of intact clay at the invert.

namespace berm::formulas {

/// The residual horizontal resistance after a sweep of some diameters under a vertical load V, N/m: H = V (1 - 0.65 [1 - exp(-s_u/(2 gamma' D))]), s_u that at
/// the invert before it. [fit: White and Cheuk 2008]
Formula clay_residual(const PipeInClay& pipe, Real V);

/// Horizontal resistance in the middle of a sweep between berms, N/m: V times 0.25 (low; + 0.3 (w/D - 0.8) beyond 0.8 D) and 0.9 (high; + 1.5 (w/D - 0.7)
/// beyond 0.7 D). `best` is the mean of both. [fit: SAFEBUCK design guideline]
Estimates safebuck_mid_sweep(const PipeInClay& pipe, Real V);

/// Horizontal resistance against the berm at the end of a sweep of many, N/m: 0.9 (w/D) s_u D (low) and 4.5 (w/D)^0.4 s_u D (high). `best` is the mean of both.
/// [fit: SAFEBUCK design guideline]
Estimates safebuck_berm(const PipeInClay& pipe);

}  // namespace berm::formulas
