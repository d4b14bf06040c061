// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <algorithm>
#include <cmath>

namespace berm::fem {

/// Goes to the part of a step at which the slope of a convex energy is a tenth of the first slope at most. `go(by)` goes on by this part of the step and gives
/// the slope there; one that is not finite is that of a folded element.
template <class Go>
void search_along_step(Real first, const Go& go)
{
  constexpr int max_chords = 12;
  constexpr Real shortest_unfolded = 1e-3;  // of a step: large deformations may fold an element
  constexpr Real gentle_slope = 0.1;        // of the first slope: ends the line search
  Real at = 1, here = go(1), low = 0, low_slope = first, high = 0, high_slope = 0;
  for (; at > shortest_unfolded && !std::isfinite(here); at /= 2) here = go(-at / 2);
  if (!(first < 0)) return;
  for (int k = 0; k < max_chords && !(std::abs(here) <= -gentle_slope * first); ++k) {
    if (here < 0 && high == 0) return;  // still downhill after the whole step
    if (here < 0)
      low = at, low_slope = here;
    else
      high = at, high_slope = here;
    // The chord creeps where the slope has a bend: every third time the middle.
    const Real next = k % 3 == 2 ? (low + high) / 2 : low + (high - low) * std::clamp(-low_slope / (high_slope - low_slope), 0.1, 0.9);
    here = go(next - at);
    at = next;
  }
}

}  // namespace berm::fem
