// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/material/undrained_test.cpp
#include "material/pore_water.hpp"

#include "core/usual.hpp"

namespace berm::material {

void describe(Describe& d, PoreWater& water)
{
  d.choice("drainage", water.drainage, {"drained", "undrained", "consolidation"},
           {.meaning = "drained: no excess pore pressure; undrained: the water stays in the pores, and its pressure follows the volume of "
                       "the soil; consolidation: it flows by Darcy's law, out of all surfaces of the soil except supports and rigid bodies",
            .required = true});
  d.value(
      "bulk_modulus", water.bulk_modulus,
      {.meaning =
           "bulk modulus of the water; absent: so stiff that, divided by the porosity, it is 30 times the P-wave modulus of the skeleton "
           "(undrained Poisson's ratio 0.495). Its compressibility makes the strength follow the mean stress: resistance is 3.4 % too "
           "large under a footing without surcharge, and 0.8 % with 2.2 GPa, that of water, which needs two to five times as many time "
           "steps (examples/strip_footing)",
       .unit = "Pa",
       .range = positive});
  d.value("porosity", water.porosity,
          {.meaning = "volume of the pores divided by that of the soil, for bulk_modulus and permeability, in laws without void_ratio",
           .range = {0.01, 0.99}});
  d.value("permeability", water.permeability,
          {.meaning = "hydraulic conductivity k of Darcy's law; without effect unless drainage is consolidation",
           .unit = "m/s",
           .range = positive});
  d.value("real_permeability", water.real_permeability,
          {.meaning = "that of the real soil, where `permeability` is larger to make the run shorter: until.real_time of a stage at rest "
                      "is then shortened by the same factor, for the same degree of consolidation",
           .unit = "m/s",
           .range = positive});
  d.value("kozeny_carman", water.kozeny_carman,
          {.meaning = "the permeability follows the porosity n as n^3 / (1 - n)^2 does; else it is constant"});
  d.value("water_depth", water.water_depth,
          {.meaning = "depth of the sea, for the pressure at which the water cavitates: -(100 kPa + 9.81 kPa/m times this depth)",
           .unit = "m",
           .range = not_negative});
  d.value("min_pressure", water.min_pressure,
          {.meaning = "smallest excess pore pressure, compression positive, instead of that of water_depth",
           .unit = "Pa",
           .range = {-infinity, 0}});
  declare_usual(d, {{"bulk_modulus", {1e5, 1e10}}, {"real_permeability", {1e-13, 0.1}}, {"water_depth", {0, 11000}}});
}

Real min_pore_pressure(const PoreWater& water)
{
  constexpr Real atmosphere = 1e5;
  return water.min_pressure.value_or(-(atmosphere + unit_weight_of_water * water.water_depth));
}

Real fast_wave_speed(Real skeleton, Real water, Real density, Real porosity)
{
  const Real of_water = water_density / porosity;
  const Real a = density * of_water - water_density * water_density,
             b = (skeleton + water) * of_water + water * density - 2 * water * water_density, c = skeleton * water;
  return std::sqrt((b + std::sqrt(b * b - 4 * a * c)) / (2 * a));
}

}  // namespace berm::material
