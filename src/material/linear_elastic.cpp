// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"

namespace berm::material {

void describe(Describe& d, LinearElastic& law)
{
  d.value("density", law.density, {.meaning = "mass of a unit of volume", .unit = "kg/m^3", .range = positive, .required = true});
  d.value("inertia_density", law.inertia_density,
          {.meaning = "density that resists acceleration, where it is not `density`, which gives the weight: of submerged soil the "
                      "saturated one and the added mass of the water",
           .unit = "kg/m^3",
           .range = positive});
  d.value("young_modulus", law.young_modulus, {.meaning = "Young's modulus", .unit = "Pa", .range = positive, .required = true});
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio", .range = {0, 0.495}, .required = true});
}

}  // namespace berm::material
