// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::problem {

/// The largest excess pore pressure in the soil of a stage without the waves that run through it, of which the degree of consolidation is made.
///
/// Loads send waves of pressure through the soil; the slowest swing has the period T = 4 H / c. The pressure of each cell is averaged over windows of 2 T, with
/// the weight 1 - cos(pi t / T): swings of the period T and of each fraction T/n vanish, and of faster ones less than 3 % is left. Means come before the largest
/// is taken, because the largest of swings is not their mean. Between the ends of two windows the mean goes on as the last two fell, as a power of the time
/// since the stage began.
struct PressureMeans {
  Real begin = 0;             ///< s, when the window in hand began
  Real weight = 0;            ///< that its pressures have together so far
  Index count = 0;            ///< windows of this stage that are over
  Real last = 0, before = 0;  ///< Pa, largest mean in the soil of the last window and of that before it
  Real largest = 0;           ///< Pa, of all in this stage
  Real now = 0;               ///< Pa, at this moment
};

/// The weight of a pressure in a window of this duration (s), so long after its beginning.
Real weight_in_window(Real since, Real window);

/// Takes the mean of the window that ends at this time, s.
void end_window(PressureMeans& means, Real mean, Real time);

/// The mean at a time since the stage began, s, where each window has a duration of `window`.
Real mean_now(const PressureMeans& means, Real since_stage, Real window);

/// Takes note of a pressure in which there are no waves.
void note_without_waves(PressureMeans& means, Real pressure);

/// U = 1 - p/p_max, 0 to 1; 0 without pressure, and until the first window of the stage is over.
Real degree_of_consolidation(const PressureMeans& means);

}  // namespace berm::problem
