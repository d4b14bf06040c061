// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/published/pipe_soil.hpp"
#include "structures/pipe/published/published.hpp"

namespace berm::pipe {

/// A vertical load V (N/m) that a pushed pipe carries at embedment w (m).
std::vector<Comparison> sand_in_push(const SandAround& sand, Real w, Real V);

/// The resistance H (N/m) against a drag, at embedment w (m) under a vertical load V (N/m).
std::vector<Comparison> sand_in_drag(const SandAround& sand, Real w, Real V, Real H);

/// The displacement u (m) at breakout, NaN where there is none, of a drag that begins at embedment w (m).
std::vector<Comparison> sand_at_breakout(const SandAround& sand, Real w, Real u);

std::vector<std::string> remarks_on(const SandAround& sand);

}  // namespace berm::pipe
