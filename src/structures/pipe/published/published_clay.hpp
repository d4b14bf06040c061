// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/published/pipe_soil.hpp"
#include "structures/pipe/published/published.hpp"

namespace berm::pipe {

/// A vertical load V (N/m) that a pushed pipe carries at embedment w (m); `heaves`: it was pushed there.
std::vector<Comparison> clay_in_push(const ClayAround& clay, Real w, Real V, bool heaves);

/// The resistance H (N/m) against a drag, at embedment w (m) under a vertical load V (N/m).
std::vector<Comparison> clay_in_drag(const ClayAround& clay, Real w, Real V, Real H);

std::vector<std::string> remarks_on(const ClayAround& clay);

}  // namespace berm::pipe
