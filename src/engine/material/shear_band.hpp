// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/usual.hpp"
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

/// How many times the strain of cells of a size, m, the soil strains in a band of a width, m: the band of cells is wider. 1 where the cells are finer.
/// [Pietruszczak and Mroz 1981; Bazant and Oh 1983]
inline Real strain_in_band(Real band_width, Real size)
{
  return std::max(Real(1), cells_of_band * size / band_width);
}

/// Declares the width of shear bands of a law with members band_width and d50, m.
template <class Law>
void describe_bands(Describe& d, Law& law)
{
  d.value("band_width", law.band_width,
          {.meaning = "width of the soil's shear bands: where cells make wider bands, the strength is that of the narrower ones; left out: "
                      "resistance depends on the cells where soil localises (dilation_angle below friction_angle, softening)",
           .unit = "m",
           .range = positive});
  d.value("d50", law.d50, {.meaning = "median size of the grains, for a band_width of 15 d50", .unit = "m", .range = positive});
  declare_usual(d, {{"d50", {1e-6, 0.2}}});
}

/// One of band_width and d50 at most.
template <class Law>
void check_bands(Describe& d, const std::string& path, const Law& law)
{
  d.check(!law.band_width || !law.d50, path + ".d50", "is another way to give band_width; keep one of them");
}

/// band_width, or 15 d50 [Muehlhaus and Vardoulakis, Geotechnique 37 (1987): 8 to 10 d50 where bands begin, 10 to 20 as they grow].
template <class Law>
std::optional<Real> given_band_width(const Law& law)
{
  constexpr Real grains = 15;
  return law.d50 ? grains * *law.d50 : law.band_width;
}

template <class Law>
Law with_grains(Law law, Real d50)
{
  law.band_width.reset();
  law.d50 = d50;
  return law;
}

/// Relative reduction of tan(phi) in shear bands; 0 without friction.
inline Real friction_lost_in_shear_bands(const Strength& strength)
{
  return strength.friction_angle > 0 ? 1 - std::tan(friction_angle_in_shear_bands(strength)) / std::tan(strength.friction_angle) : 0;
}

}  // namespace berm::material
