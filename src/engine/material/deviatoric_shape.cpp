// SPDX-License-Identifier: BSD-3-Clause
#include "material/deviatoric_shape.hpp"

namespace berm::material {

void describe_deviatoric_shape(Describe& d, DeviatoricShape& shape)
{
  d.choice("deviatoric_shape", shape, {"circle", "matsuoka_nakai"},
           {.meaning = "strength over the direction of the deviator: the M of triaxial compression in all directions, or by Matsuoka and "
                       "Nakai, with the friction angle of triaxial compression in triaxial extension and a little more between the two, as "
                       "in plane strain"});
}

StrengthShape strength_shape(DeviatoricShape shape, Real friction_angle)
{
  if (shape == DeviatoricShape::circle) return {};
  const Real sine = std::sin(friction_angle), b = 2 * sine * (3 + sine) / ((3 - sine) * (3 - sine));
  const Real middle = std::sqrt(1 + b), extension = (3 + sine) / (3 - sine);
  return {b, {middle, (1 - extension) / 2, (1 + extension) / 2 - middle}};
}

Invariants equivalent_invariants(const StrengthShape& shape, const SymTensor<3>& stress, Real min_pressure)
{
  Invariants now = invariants(stress, min_pressure);
  if (shape.is_circle()) return now;
  SymTensor<3> deviator = stress;
  for (int k = 0; k < 3; ++k) deviator[k] -= trace(stress) / 3;
  now.q *= slope_over_slope_there(shape, cosine_of_three_theta(deviator, now.pressure));
  return now;
}

}  // namespace berm::material
