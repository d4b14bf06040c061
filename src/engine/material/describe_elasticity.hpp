// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"

namespace berm::material {

/// Declares the water in the pores.
template <class Law>
void describe_water(Describe& d, Law& law)
{
  d.optional_table("water", law.water,
                   {.meaning = "the water in the pores, for laws of effective stress; left out: drained, or total stress"});
}

/// Declares the density that gives the weight, or the unit weight below water instead. Neither leaves it 0, both make it NaN: material::check refuses that.
template <class Law>
void describe_weight(Describe& d, Law& law)
{
  constexpr Real gravity = 9.80665;
  std::optional<Real> density, weight;
  if (law.density > 0) density = law.density;
  d.value("density", density,
          {.meaning = "mass per volume, which gives the weight: for submerged soil its submerged unit weight divided by gravity",
           .unit = "kg/m^3",
           .range = positive});
  d.value("submerged_unit_weight", weight,
          {.meaning = "instead of `density`: submerged unit weight under one gravity of 9.80665 m/s2", .unit = "N/m^3", .range = positive});
  law.density = density && weight ? nan : weight ? *weight / gravity : density.value_or(0);
}

/// Declares the densities of a law, and the water in its pores.
template <class Law>
void describe_density(Describe& d, Law& law)
{
  describe_weight(d, law);
  d.value("inertia_density", law.inertia_density,
          {.meaning = "density that gives the inertia, where it is not `density`, which gives the weight: for submerged soil the saturated "
                      "density plus the added mass of the water",
           .unit = "kg/m^3",
           .range = positive});
  describe_water(d, law);
}

/// Declares the parameters of every law with isotropic linear elasticity: densities, Young's modulus, Poisson's ratio; and the profile over depth, which may
/// give the modulus. needs_modulus: whether nothing else gives it; else 0 stands for none.
template <class Law>
void describe_elasticity(Describe& d, Law& law, bool needs_modulus = true)
{
  describe_density(d, law);
  d.optional_table("profile", law.profile, {.meaning = "values by depth, linear between the entries and constant beyond them"});
  d.value("young_modulus", law.young_modulus,
          {.meaning = "Young's modulus",
           .unit = "Pa",
           .range = needs_modulus ? positive : not_negative,
           .required = needs_modulus && law.profile.young_modulus.empty()});
  if (law.young_modulus == 0 && !law.profile.young_modulus.empty()) law.young_modulus = law.profile.young_modulus.front();
  d.value("young_modulus_gradient", law.young_modulus_gradient,
          {.meaning = "increase of Young's modulus with depth below the seabed at the start; a particle keeps that of its initial position",
           .unit = "Pa/m"});
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio", .range = {0, 0.495}, .required = true});
}

/// Declares the least and the largest mean effective stress of a law whose stiffness grows with it.
template <class Law>
void describe_pressure_limits(Describe& d, Law& law)
{
  d.value("min_pressure", law.min_pressure,
          {.meaning = "mean effective stress at which soil separates; soil of this law never has less, whatever its initial stress",
           .unit = "Pa",
           .range = positive});
  d.value("max_pressure", law.max_pressure,
          {.meaning = "mean effective stress up to which soil becomes stiffer; it sets the time step, so take two or three times the "
                      "largest expected value: beyond it soil has the stiffness at that stress, softer than the law",
           .unit = "Pa",
           .range = positive,
           .required = true});
}

/// Declares the parameters of PressureElasticity but for its index.
template <class Law>
void describe_pressure_elasticity(Describe& d, Law& law)
{
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio", .range = {0, 0.495}, .required = true});
  describe_pressure_limits(d, law);
}

/// min_pressure < max_pressure.
template <class Law>
void check_pressures(Describe& d, const std::string& path, const Law& law)
{
  d.check(law.min_pressure < law.max_pressure, path + ".max_pressure", "must be larger than min_pressure");
}

}  // namespace berm::material
