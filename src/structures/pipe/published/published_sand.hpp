// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/published/pipe_soil.hpp"
#include "structures/pipe/published/published.hpp"

namespace berm::pipe {

/// A vertical load V (N/m) that a pushed pipe carries at embedment w (m).
std::vector<Comparison> sand_in_push(const SandAround& sand, Real w, Real V);

/// The resistance H (N/m) at breakout, at embedment w (m) under a vertical load V (N/m).
std::vector<Comparison> sand_in_drag(const SandAround& sand, Real w, Real V, Real H);

/// The same at the end of a long drag.
std::vector<Comparison> sand_after_sweep(const SandAround& sand, Real w, Real V, Real H);

std::vector<std::string> remarks_on(const SandAround& sand);

}  // namespace berm::pipe
