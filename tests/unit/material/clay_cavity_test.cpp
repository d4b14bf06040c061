// SPDX-License-Identifier: BSD-3-Clause
#include "clay_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// Pressure in excess of the first one over s_u in a cavity that grows from a radius of 1 to `radius` in incompressible soil; `power` is 2 of a cylinder, 3
/// of a sphere. All strains follow from the growth, so that the law alone is tested: with s = (a/r)^power,
///
///   p = 2 (power - 1) / power int_0^1 tau(s)/s ds,   tau = (s_theta - s_r)/2 of the soil that is now at s.
///
/// The radius grows by the factor exp(`rate` t).
template <int dim>
Real cavity_pressure(const Clay& clay, Real radius, int power, Real rate)
{
  constexpr int points = 200, steps = 1000;
  const PreparedClay law = prepare(clay);
  const Real grown = std::log(radius);
  Real sum = 0;
  for (int k = 0; k < points; ++k) {
    const Real s = (k + 0.5) / points;                             // the integrand has no singularity: tau falls with s
    const Real first = std::pow(radius, power) * (1 / s - 1) + 1;  // r0^power of the soil
    ClayParticle<dim> particle;
    Real r = std::pow(first, 1. / power);
    for (int n = 1; n <= steps; ++n) {
      const Real a = std::exp(grown * n / steps), now = std::pow(first + std::pow(a, power) - 1, 1. / power), hoop = std::log(now / r);
      r = now;
      Increment<dim, Real> increment;
      increment.strain[0] = -(power - 1) * hoop;
      increment.strain[1] = hoop;
      if (power == 3) increment.strain[2] = hoop;
      increment.dt = grown / steps / rate;
      update(law, particle.stress, increment, particle.state);
    }
    sum += (particle.stress[1] - particle.stress[0]) / 2 / s / points;
  }
  return 2. * (power - 1) / power * sum / clay_strength;
}

/// 0.2 %: midpoints of 200 parts of s across the kink where yield begins, 1000 increments, and a Poisson's ratio of 0.49 that no volume change shows.
constexpr Real cavity_precision = 2e-3;

TEST(ClayCavity, pressures_of_growing_cavities_are_exact)
{
  struct Row {
    Real radius, cylinder, sphere, cylinder_10, sphere_10, cylinder_25, sphere_25;
  };
  for (const Row& row : {Row{1.1, 3.856, 5.622, 3.827, 5.560, 3.844, 5.597},
                         {1.5, 5.020, 7.008, 4.898, 6.790, 4.970, 6.917},
                         {2, 5.320, 7.299, 5.142, 7.005, 5.245, 7.173}}) {
    const Clay soft_10 = softening_clay(1 / 0.3, 10), soft_25 = softening_clay(1 / 0.3, 25);
    EXPECT_NEAR(cavity_pressure<2>(plain_clay(), row.radius, 2, 1), row.cylinder, cavity_precision * row.cylinder);
    EXPECT_NEAR(cavity_pressure<2>(soft_10, row.radius, 2, 1), row.cylinder_10, cavity_precision * row.cylinder_10);
    EXPECT_NEAR(cavity_pressure<2>(soft_25, row.radius, 2, 1), row.cylinder_25, cavity_precision * row.cylinder_25);
    EXPECT_NEAR(cavity_pressure<2>(plain_clay(), row.radius, 3, 1), row.sphere, cavity_precision * row.sphere);
    EXPECT_NEAR(cavity_pressure<2>(soft_10, row.radius, 3, 1), row.sphere_10, cavity_precision * row.sphere_10);
    EXPECT_NEAR(cavity_pressure<2>(soft_25, row.radius, 3, 1), row.sphere_25, cavity_precision * row.sphere_25);
  }
}

TEST(ClayCavity, pressures_of_cavities_that_grow_at_a_rate_are_exact)
{
  Clay both = fast_clay();
  both.sensitivity = 1 / 0.3;
  both.ductility = 10;
  for (const auto& [rate, cylinder, sphere, soft_cylinder, soft_sphere] :
       {std::array{1e2, 5.908, 8.195, 5.696, 7.840}, {1e3, 6.331, 8.779, 6.103, 8.396}}) {
    EXPECT_NEAR(cavity_pressure<2>(fast_clay(), 2, 2, rate * reference_rate), cylinder, cavity_precision * cylinder);
    EXPECT_NEAR(cavity_pressure<2>(fast_clay(), 2, 3, rate * reference_rate), sphere, cavity_precision * sphere);
    EXPECT_NEAR(cavity_pressure<2>(both, 2, 2, rate * reference_rate), soft_cylinder, cavity_precision * soft_cylinder);
    EXPECT_NEAR(cavity_pressure<2>(both, 2, 3, rate * reference_rate), soft_sphere, cavity_precision * soft_sphere);
  }
}

}  // namespace
}  // namespace berm::material::this_file
