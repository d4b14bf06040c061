// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/parameters.hpp"
#include "settings/stage.hpp"

namespace berm::sea {

/// Where a pipe went, by the rows of a load history: across from where it lay, and the embedment of its invert, m.
struct Track {
  std::vector<Real> time, u, w;
};

/// Numbers of a track, m: the largest distance from where the pipe lay, the largest displacement between two turns that are 1 % of D apart or more, where it ends, and the largest embedment.
struct TrackNumbers {
  Real largest = 0, half_cycle = 0, end = 0, largest_w = 0;
};
TrackNumbers numbers_of(const Track& track, Real diameter);

/// A pipe of a mass (kg/m, with added mass) that the water of a stage moves on the soil of a macro-element, from a state on:
///
///   m dv/dt = H_water(t, v, w) - H_soil(u, w),   V_soil(u, w) = V_water(t, v, w), 0 at least,
///
/// by steps of a sixteenth of a row at most, whose end velocity has 0.6 of the movement; a step without a solution, or of more than D/20, is halved. Where lift is more than the weight the pipe slides freely. Throws RunError where halving does not help.
Track march(const macro_element::Parameters& soil, const berm_macro_element_state& laid, const settings::StageSettings& water, Real mass);

}  // namespace berm::sea
