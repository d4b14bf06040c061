// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"

namespace berm::material {

/// Declares the parameters of every law with isotropic linear elasticity: densities, Young's modulus, Poisson's ratio; and the profile over depth, which may
/// give the modulus. needs_modulus: whether nothing else gives it.
template <class Law>
void describe_elasticity(Describe& d, Law& law, bool needs_modulus = true)
{
  d.value("density", law.density, {.meaning = "mass per volume", .unit = "kg/m^3", .range = positive, .required = true});
  d.value("inertia_density", law.inertia_density,
          {.meaning = "density that gives the inertia, where it is not `density`, which gives the weight: of submerged soil the "
                      "saturated one and the added mass of the water",
           .unit = "kg/m^3",
           .range = positive});
  d.optional_table("profile", law.profile, {.meaning = "values over depth, linear between the entries and constant beyond them"});
  d.value("young_modulus", law.young_modulus,
          {.meaning = "Young's modulus", .unit = "Pa", .range = positive, .required = needs_modulus && law.profile.young_modulus.empty()});
  if (law.young_modulus == 0 && !law.profile.young_modulus.empty()) law.young_modulus = law.profile.young_modulus.front();
  d.value(
      "young_modulus_gradient", law.young_modulus_gradient,
      {.meaning = "increase of Young's modulus with depth below the bed's surface at the start; a particle keeps that of where it began",
       .unit = "Pa/m"});
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio", .range = {0, 0.495}, .required = true});
}

}  // namespace berm::material
