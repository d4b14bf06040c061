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

TEST(ShearBand, keeps_the_friction_of_cells_as_fine_as_bands_and_tends_to_that_of_bands)
{
  const Strength sand = *strength_at_rest(soil(0, 35, 0));
  const Real in_bands = friction_angle_in_shear_bands(sand);
  for (const Real fine : {0.1, 0.25}) EXPECT_EQ(friction_angle_in_cells(sand, 1, fine), sand.friction_angle) << fine;
  EXPECT_NEAR(friction_angle_in_cells(sand, 1, 2), (in_bands + sand.friction_angle) / 2, 1e-14);  // (1/8)^(1/3)
  EXPECT_NEAR(friction_angle_in_cells(sand, 1, 1e12), in_bands, 1e-4);
}

TEST(ShearBand, lowers_friction_and_cohesion_of_a_law_by_the_same_share)
{
  MohrCoulomb law = soil(2e3, 35, 5);
  law.cohesion_gradient = 1e3;
  law.d50 = 2e-3;
  const MohrCoulomb here = regularised_for(law, 0.06);  // w = 30 mm
  const Real share = std::tan(here.friction_angle) / std::tan(law.friction_angle);
  EXPECT_LT(here.friction_angle, law.friction_angle);
  EXPECT_NEAR(here.friction_angle, friction_angle_in_cells(*strength_at_rest(law), 0.03, 0.06), 1e-15);
  EXPECT_NEAR(here.cohesion, share * law.cohesion, 1e-9);
  EXPECT_NEAR(here.cohesion_gradient, share * law.cohesion_gradient, 1e-9);
  EXPECT_EQ(here.dilation_angle, law.dilation_angle);
  EXPECT_EQ(regularised_for(here, 0.6), here) << "once";
  const Real own[2] = {5e3, law.young_modulus};
  const PreparedMohrCoulomb prepared = prepare(here), by_own = with_local(prepared, own);
  EXPECT_NEAR(by_own.strength, share * 5e3 * std::cos(here.friction_angle), 1e-9);
}

TEST(ShearBand, changes_no_law_without_a_width_or_with_associated_flow)
{
  EXPECT_EQ(regularised_for(soil(1e3, 35, 0), 1), soil(1e3, 35, 0));
  MohrCoulomb associated = soil(1e3, 35, 35);
  associated.band_width = 1e-3;
  EXPECT_EQ(regularised_for(associated, 1), associated);
}

}  // namespace
}  // namespace berm::material::this_file
