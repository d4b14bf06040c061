// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_queries.hpp"

#include <cmath>

namespace berm::material {

/// The friction angle phi*, rad, of soil in a shear band, whose plane does not change its length: tan(phi*) = cos(psi) sin(phi) / (1 - sin(psi) sin(phi)),
/// phi where psi = phi. [Davis 1968; Drescher and Detournay 1993]
inline Real friction_angle_in_shear_bands(const Strength& strength)
{
  const Real phi = std::sin(strength.friction_angle), psi = strength.dilation_angle;
  return std::atan(std::cos(psi) * phi / (1 - std::sin(psi) * phi));
}

/// Relative reduction of tan(phi) in shear bands; 0 without friction.
inline Real friction_lost_in_shear_bands(const Strength& strength)
{
  return strength.friction_angle > 0 ? 1 - std::tan(friction_angle_in_shear_bands(strength)) / std::tan(strength.friction_angle) : 0;
}

}  // namespace berm::material
