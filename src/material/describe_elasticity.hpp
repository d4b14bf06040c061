// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::material {

/// Declares the parameters of every law with isotropic linear elasticity: densities, Young's modulus, Poisson's ratio.
template <class Law>
void describe_elasticity(Describe& d, Law& law)
{
  d.value("density", law.density, {.meaning = "mass per volume", .unit = "kg/m^3", .range = positive, .required = true});
  d.value("inertia_density", law.inertia_density,
          {.meaning = "density that gives the inertia, where it is not `density`, which gives the weight: of submerged soil the "
                      "saturated one and the added mass of the water",
           .unit = "kg/m^3",
           .range = positive});
  d.value("young_modulus", law.young_modulus, {.meaning = "Young's modulus", .unit = "Pa", .range = positive, .required = true});
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio", .range = {0, 0.495}, .required = true});
}

}  // namespace berm::material
