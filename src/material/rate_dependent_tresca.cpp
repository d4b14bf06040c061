// SPDX-License-Identifier: BSD-3-Clause
#include "material/rate_dependent_tresca.hpp"

#include "material/describe_elasticity.hpp"
#include "material/mohr_coulomb.hpp"

#include <algorithm>

namespace berm::material {

void describe(Describe& d, RateDependentTresca& law)
{
  describe_elasticity(d, law);
  d.value("undrained_strength", law.undrained_strength,
          {.meaning = "undrained shear strength up to the reference rate",
           .unit = "Pa",
           .range = not_negative,
           .required = law.profile.strength.empty()});
  d.value("undrained_strength_gradient", law.undrained_strength_gradient,
          {.meaning =
               "increase of the undrained strength with depth below the bed's surface at the start; a particle keeps that of where it "
               "began",
           .unit = "Pa/m"});
  d.value("rate_parameter", law.rate_parameter,
          {.meaning = "relative increase of the strength for each tenfold shear strain rate above the reference rate",
           .range = not_negative,
           .required = true});
  d.value(
      "reference_rate", law.reference_rate,
      {.meaning = "shear strain rate up to which the strength is undrained_strength", .unit = "1/s", .range = positive, .required = true});
  take_surface_strength(law);
}

std::string law_name(const RateDependentTresca&)
{
  return "rate-dependent Tresca";
}

std::vector<FieldInfo> state_fields(const RateDependentTresca&)
{
  return {{"rate_strength", "strength added by the strain rate", "Pa"}};
}

std::optional<Strength> strength_at_rest(const RateDependentTresca& law)
{
  return Strength{.cohesion = law.undrained_strength, .cohesion_gradient = law.undrained_strength_gradient};
}

std::optional<Real> shear_strength(const RateDependentTresca& law, Real /*middle*/, const Real* state)
{
  return law.undrained_strength + state[0];
}

PreparedRateDependentTresca prepare(const RateDependentTresca& law)
{
  MohrCoulomb tresca;
  tresca.young_modulus = law.young_modulus;
  tresca.poisson_ratio = law.poisson_ratio;
  tresca.cohesion = law.undrained_strength;
  return {elasticity(law), prepare(tresca), law.rate_parameter * law.undrained_strength, law.reference_rate, law.rate_parameter};
}

}  // namespace berm::material
