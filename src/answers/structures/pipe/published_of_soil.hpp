// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/pipe_soil.hpp"
#include "structures/pipe/published.hpp"

namespace berm::pipe {

/// A vertical load V (N/m) that a pushed pipe carries at embedment w (m); `heaves`: it was pushed there.
std::vector<Comparison> clay_in_push(const ClayAround& clay, Real w, Real V, bool heaves);

/// The resistance H (N/m) against a drag, at embedment w (m) under a vertical load V (N/m).
std::vector<Comparison> clay_in_drag(const ClayAround& clay, Real w, Real V, Real H);

/// The same at breakout, where the formulas of design codes hold.
std::vector<Comparison> clay_at_breakout(const ClayAround& clay, Real w, Real V, Real H);

/// A long drag at its end.
struct SweepResults {
  Real w_begin;                           ///< m, where it began
  Real w, V;                              ///< m, N/m: means over its end
  Real middle;                            ///< N/m, H in the middle of its travel
  Real residual = nan, w_residual = nan;  ///< N/m, its plateau, and m, the embedment there; NaN where none was reached
  Real berm = nan;                        ///< N/m, H against a berm at its end; NaN where it met none
};

/// What it has, beside the residual resistance; and beside that of a sweep between the berms that others left.
std::vector<Comparison> clay_after_sweep(const ClayAround& clay, const SweepResults& sweep);
std::vector<Comparison> clay_between_berms(const ClayAround& clay, const SweepResults& sweep);

std::vector<std::string> remarks_on(const ClayAround& clay);

/// A vertical load V (N/m) that a pushed pipe carries at embedment w (m).
std::vector<Comparison> sand_in_push(const SandAround& sand, Real w, Real V);

/// The resistance H (N/m) at breakout, at embedment w (m) under a vertical load V (N/m).
std::vector<Comparison> sand_in_drag(const SandAround& sand, Real w, Real V, Real H);

/// The residual of a long drag.
std::vector<Comparison> sand_after_sweep(const SandAround& sand, const SweepResults& sweep);

std::vector<std::string> remarks_on(const SandAround& sand);

/// The largest resistance against a lift (N/m), and the travel to it (m), of a pipe whose invert was at w (m).
std::vector<Comparison> in_uplift(const PipeSoil& soil, Real w, Real R, Real travel);

}  // namespace berm::pipe
