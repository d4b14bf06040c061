// SPDX-License-Identifier: BSD-3-Clause
#include "material/shear_band.hpp"

#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// Shear over normal stress on the line that does not change its length while soil without cohesion flows: the plane of a shear band.
Real friction_of_band(const MohrCoulomb& law)
{
  const Real compression = 1 + std::sin(law.friction_angle),
             min = 1 - std::sin(law.friction_angle);  // principal stresses, over their mean
  const Real shortening = 1 - std::sin(law.dilation_angle),
             lengthening = 1 + std::sin(law.dilation_angle);  // principal strain rates, coaxial
  const Real cos2 = lengthening / (shortening + lengthening),
             sin2 = 1 - cos2;  // -cos2 shortening + sin2 lengthening = 0, cos2 of the line's angle
  const Real shear = (compression - min) * std::sqrt(sin2 * cos2);
  const Real normal = sin2 * compression + cos2 * min;
  return shear / normal;
}

TEST(ShearBand, bears_what_the_line_without_extension_bears)
{
  for (const auto& [friction, dilation] : {std::pair{35., 0.}, {35., 10.}, {20., 0.}, {45., 30.}}) {
    const MohrCoulomb law = soil(0, friction, dilation);
    EXPECT_NEAR(friction_lost_in_shear_bands(*strength_at_rest(law)), 1 - friction_of_band(law) / std::tan(law.friction_angle), 1e-12)
        << friction << ' ' << dilation;
  }
}

TEST(ShearBand, loses_nothing_where_flow_is_associated)
{
  EXPECT_NEAR(friction_lost_in_shear_bands(*strength_at_rest(soil(0, 35, 35))), 0, 1e-15);
  EXPECT_EQ(friction_lost_in_shear_bands(*strength_at_rest(soil(5e3, 0, 0))), 0);
}

}  // namespace
}  // namespace berm::material::this_file
