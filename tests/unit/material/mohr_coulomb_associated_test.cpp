// SPDX-License-Identifier: BSD-3-Clause
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// The greatest shear stress that a law carries at this mean of the extreme principal stresses: radius of Mohr's circle at yield, Pa.
Real strength_at(const MohrCoulomb& law, Real middle)
{
  return law.cohesion * std::cos(law.friction_angle) - middle * std::sin(law.friction_angle);
}

TEST(AssociatedLaw, flows_normal_to_its_surface_with_the_dilation_angle)
{
  const MohrCoulomb law = soil(1e3, 35, 10), same = associated(law, {{-3e4, -5e4, -4e4, 1e3}});
  EXPECT_EQ(same.friction_angle, law.dilation_angle);
  EXPECT_EQ(same.dilation_angle, law.dilation_angle);
  EXPECT_EQ(same.young_modulus, law.young_modulus);
  EXPECT_EQ(same.density, law.density);
}

TEST(AssociatedLaw, has_the_same_yield_value_along_pure_shear_at_the_same_mean)
{
  for (const MohrCoulomb& law : {soil(0, 35, 0), soil(0, 35, 10), soil(1e3, 30, 5), soil(1e4, 45, 0, 2e3)}) {
    const SymTensor<2> first{{-3e4, -5e4, -4e4, 4e3}};
    const MohrCoulomb same = associated(law, first);
    EXPECT_NEAR(strength_at(same, -4e4) / strength_at(law, -4e4), 1, 1e-14);
    for (const Real shear : {0., 5e3, 1e4, 2e4, 3e4}) {
      const SymTensor<2> stress{{-4e4 + 5e3, -4e4 - 5e3, -4e4, shear}};
      EXPECT_NEAR(yield_value(prepare(same), stress), yield_value(prepare(law), stress), 1e-10 * 4e4) << shear;
    }
  }
}

TEST(AssociatedLaw, counts_the_stress_across_the_plane_where_it_is_extreme)
{
  const MohrCoulomb law = soil(0, 35, 0);
  EXPECT_NEAR(strength_at(associated(law, {{-3e4, -3e4, -7e4, 0}}), 0), 5e4 * std::sin(law.friction_angle), 1e-9);
}

TEST(AssociatedLaw, of_a_law_with_associated_flow_is_that_law)
{
  for (const MohrCoulomb& law : {soil(0, 35, 35), soil(1e3, 0, 0, 5e2), soil(1e3, 20, 20)}) {
    const MohrCoulomb same = associated(law, {{-3e4, -5e4, -4e4, 1e3}});
    EXPECT_EQ(same.cohesion, law.cohesion);
    EXPECT_EQ(same.friction_angle, law.friction_angle);
    EXPECT_EQ(same.tension_cutoff, law.tension_cutoff);
  }
}

TEST(AssociatedLaw, from_no_stress_has_the_strength_of_the_cohesion_and_no_more_tension)
{
  const MohrCoulomb sand = associated(soil(0, 35, 0), {});
  EXPECT_EQ(sand.cohesion, 0);
  EXPECT_EQ(*sand.tension_cutoff, 0);
  const MohrCoulomb clay = soil(1e3, 30, 0);
  EXPECT_NEAR(associated(clay, {}).cohesion, 1e3 * std::cos(clay.friction_angle), 1e-10);
}

TEST(AssociatedLaw, never_carries_more_tension_than_the_law)
{
  // The apex is c cot(phi) = 1732 Pa.
  EXPECT_NEAR(*associated(soil(1e3, 30, 0), {{-1e5, -1e5, -1e5, 0}}).tension_cutoff, 1e3 * std::sqrt(3.), 1e-9);
  EXPECT_NEAR(*associated(soil(1e3, 30, 0, 5e3), {{-1e5, -1e5, -1e5, 0}}).tension_cutoff, 1e3 * std::sqrt(3.), 1e-9);
  EXPECT_EQ(*associated(soil(1e3, 30, 0, 5e2), {{-1e5, -1e5, -1e5, 0}}).tension_cutoff, 5e2);
}

TEST(AssociatedLaw, from_a_stress_beyond_the_apex_has_no_negative_strength)
{
  EXPECT_NEAR(associated(soil(1e3, 30, 0), {{9e3, 9e3, 9e3, 0}}).cohesion, 0, 1e-10);
  EXPECT_GE(associated(soil(0, 30, 0), {{9e3, 9e3, 9e3, 0}}).cohesion, 0);
}

TEST(MohrCoulombAtDepth, has_the_cohesion_of_its_depth_and_that_of_the_surface_above_it)
{
  MohrCoulomb law = soil(1e3, 0, 0);
  law.cohesion_gradient = 2e3;
  EXPECT_EQ(at_depth(law, 3).cohesion, 7e3);
  EXPECT_EQ(at_depth(law, 3).cohesion_gradient, 0);
  EXPECT_EQ(at_depth(law, -1).cohesion, 1e3);
}

}  // namespace
}  // namespace berm::material::this_file
