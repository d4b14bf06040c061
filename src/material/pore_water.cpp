// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/material/undrained_test.cpp
#include "material/pore_water.hpp"

namespace berm::material {

void describe(Describe& d, PoreWater& water)
{
  d.choice("drainage", water.drainage, {"drained", "undrained"},
           {.meaning = "drained: no excess pore pressure; undrained: the water stays in the pores, and its pressure follows the volume of "
                       "the soil",
            .required = true});
  d.value("bulk_modulus", water.bulk_modulus,
          {.meaning =
               "bulk modulus of the water; absent: so stiff that over the porosity it is 30 times the P-wave modulus of the skeleton "
               "(undrained Poisson's ratio 0.495). Water has 2.2 GPa, which costs many more time steps",
           .unit = "Pa",
           .range = positive});
  d.value("porosity", water.porosity,
          {.meaning = "volume of the pores over that of the soil, for bulk_modulus, of laws without void_ratio", .range = {0.01, 0.99}});
  d.value("water_depth", water.water_depth,
          {.meaning = "depth of the sea, for the pressure at which the water cavitates: -(100 kPa + 9.81 kPa/m times this depth)",
           .unit = "m",
           .range = not_negative});
  d.value("min_pressure", water.min_pressure,
          {.meaning = "smallest excess pore pressure, compression positive, instead of that of water_depth",
           .unit = "Pa",
           .range = {-infinity, 0}});
}

Real min_pore_pressure(const PoreWater& water)
{
  constexpr Real atmosphere = 1e5, unit_weight = 9810;
  return water.min_pressure.value_or(-(atmosphere + unit_weight * water.water_depth));
}

}  // namespace berm::material
