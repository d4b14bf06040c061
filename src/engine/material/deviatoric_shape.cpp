// SPDX-License-Identifier: BSD-3-Clause
#include "material/deviatoric_shape.hpp"

namespace berm::material {

void describe_deviatoric_shape(Describe& d, DeviatoricShape& shape)
{
  d.choice("deviatoric_shape", shape, {"circle", "matsuoka_nakai"},
           {.meaning = "strength by direction of the deviator: the stress ratio of triaxial compression in all directions; or by "
                       "Matsuoka and Nakai, the friction angle of triaxial compression in triaxial extension, and about 4 deg more in "
                       "plane strain"});
}

Invariants equivalent_invariants(DeviatoricShape shape, const SymTensor<3>& stress, Real min_pressure)
{
  Invariants now = invariants(stress, min_pressure);
  if (shape == DeviatoricShape::circle) return now;
  SymTensor<3> deviator = stress;
  for (int k = 0; k < 3; ++k) deviator[k] -= trace(stress) / 3;
  const Real c = cosine_of_three_theta(deviator, now.pressure);
  now.q *= equivalent_over_actual(equivalent_ratio(now.q / now.pressure, c), c);
  return now;
}

}  // namespace berm::material
