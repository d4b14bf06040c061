// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/mohr_coulomb.hpp"

#include <cmath>

namespace berm {

/// The part of tan(phi) that soil with psi < phi loses in a shear band, whose plane bears tan(phi*) = cos(psi) sin(phi) / (1 - sin(psi) sin(phi)) only; 0
/// for associated soil and without friction. [Davis 1968; Drescher and Detournay 1993]
inline Real friction_lost_in_shear_bands(const MohrCoulomb& law)
{
  if (!(law.friction_angle > 0)) return 0;
  const Real phi = std::sin(law.friction_angle), psi = law.dilation_angle;
  return 1 - std::cos(psi) * phi / (1 - std::sin(psi) * phi) / std::tan(law.friction_angle);
}

}  // namespace berm
