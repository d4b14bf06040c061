// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/formulas/pipe_in_clay.hpp"

// What a pipe meets that is swept over clay, once or many times; the strength is that of intact clay at the invert.

namespace berm::formulas {

/// The residual horizontal resistance after a sweep of some diameters under a vertical load V, N/m: H = V (1 - 0.65 [1 - exp(-s_u/(2 gamma' D))]), s_u that at
/// the invert before it. [fit: White and Cheuk 2008]
Formula clay_residual(const PipeInClay& pipe, Real V);

/// The horizontal resistance at breakout under a vertical load V, N/m: H = 0.2 V + 3 D s_u (w/D) (gamma' D/s_u)^(1/2).
/// [recalled: Bruton and others 2006]
Formula clay_breakout_bruton(const PipeInClay& pipe, Real V);

/// By how much a sweep of many under a vertical load V lets the pipe sink, m: D 0.015 (V/(D s_u))^2.3. [fit: White and Cheuk 2008]
Formula clay_sinking(const PipeInClay& pipe, Real V);

/// By how much a sweep of many, of this length (m), that sinks by `sinking` (m) lets the resistance of a berm grow, N/m: s_u D (sweep sinking/D^2)^(1/2).
/// [fit: White and Cheuk 2008]
Formula clay_berm_growth(const PipeInClay& pipe, Real sweep, Real sinking);

/// By how much a cycle of sweeps under a vertical load V lets the pipe sink, m: 0.01 D (V/(D s_u))^3 (low) and 0.15 D (V/(D s_u))^2 (high). `best` is the mean
/// of both. [fit: SAFEBUCK design guideline]
Estimates safebuck_sinking(const PipeInClay& pipe, Real V);

/// Horizontal resistance in the middle of a sweep between berms, N/m: V times 0.25 (low; + 0.3 (w/D - 0.8) beyond 0.8 D) and 0.9 (high; + 1.5 (w/D - 0.7)
/// beyond 0.7 D). `best` is the mean of both. [fit: SAFEBUCK design guideline]
Estimates safebuck_mid_sweep(const PipeInClay& pipe, Real V);

/// Horizontal resistance against the berm at the end of a sweep of many, N/m: 0.9 (w/D) s_u D (low) and 4.5 (w/D)^0.4 s_u D (high). `best` is the mean of both.
/// [fit: SAFEBUCK design guideline]
Estimates safebuck_berm(const PipeInClay& pipe);

}  // namespace berm::formulas
