// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/fit_soil.hpp"

namespace berm::soil_fit {

/// What a laboratory reports of a test. NaN where it does not show it.
struct Marks {
  Real friction_angle_peak = nan;  ///< rad, of a drained triaxial or biaxial test: at the largest stress ratio
  Real dilation_angle_peak =
      nan;  ///< rad, of a triaxial one: sin psi = -s / (2 - s), in extension -s / (2 + s), s = d eps_v / d eps_a by a line over 1 % of strain to either side of it, or over five rows
  Real E50 = nan;  ///< Pa, from the first row to half of the largest rise of q
  Real s_u = nan;  ///< Pa, undrained: half of the largest q, in simple shear the largest tau
};

/// Of what was measured, and of what the law makes at the same rows.
Marks marks_measured(const FittedTest& test);
Marks marks_computed(const FittedTest& test);

}  // namespace berm::soil_fit
