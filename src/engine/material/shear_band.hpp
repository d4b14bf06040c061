// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_queries.hpp"

#include <algorithm>
#include <cmath>

namespace berm::material {

/// The friction angle phi*, rad, of soil in a shear band, whose plane does not change its length: tan(phi*) = cos(psi) sin(phi) / (1 - sin(psi) sin(phi)),
/// phi where psi = phi. [Davis 1968; Drescher and Detournay 1993]
inline Real friction_angle_in_shear_bands(const Strength& strength)
{
  const Real phi = std::sin(strength.friction_angle), psi = strength.dilation_angle;
  return std::atan(std::cos(psi) * phi / (1 - std::sin(psi) * phi));
}

/// How many cells wide bands are, whatever the size of these. [docs/decisions/0018, 0063]
constexpr Real cells_of_band = 4;

/// The friction angle, rad, with which cells of a size, m, carry as much as soil whose shear bands have a width, m: bands are as wide as some four cells, and the
/// narrower they are beside the mechanism, the more of the loss they make (docs/theory/soil_and_contact.md, Shear bands). phi where the cells are as fine as the bands.
inline Real friction_angle_in_cells(const Strength& strength, Real band_width, Real size)
{
  const Real in_bands = friction_angle_in_shear_bands(strength);
  return in_bands + (strength.friction_angle - in_bands) * std::min(Real(1), std::cbrt(band_width / (cells_of_band * size)));
}

/// Relative reduction of tan(phi) in shear bands; 0 without friction.
inline Real friction_lost_in_shear_bands(const Strength& strength)
{
  return strength.friction_angle > 0 ? 1 - std::tan(friction_angle_in_shear_bands(strength)) / std::tan(strength.friction_angle) : 0;
}

}  // namespace berm::material
