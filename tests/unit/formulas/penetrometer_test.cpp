// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/penetrometer.hpp"

#include <array>
#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// Tabulated values have four digits: half a unit of the last.
constexpr Real digits = 0.0051;

TEST(Penetrometer, cavities_have_the_limits_of_the_tables)
{
  constexpr std::array rigidity{50., 100., 200., 300., 500.}, sphere{6.549, 7.474, 8.398, 8.938, 9.619},
      cylinder{4.912, 5.605, 6.298, 6.704, 7.215};
  for (std::size_t k = 0; k < rigidity.size(); ++k) {
    EXPECT_NEAR(sphere_limit(rigidity[k]).value, sphere[k], 0.0005);
    EXPECT_NEAR(cylinder_limit(rigidity[k]).value, cylinder[k], 0.0005);
  }
  EXPECT_FALSE(sphere_limit(0.5).valid);
}

TEST(Penetrometer, cone_factors_of_a_smooth_cone_lie_within_a_sixth)
{
  constexpr std::array rigidity{50., 100., 200., 300., 500.}, path{8.35, 9.72, 11.34, 12.51, 14.43},
      remeshed{9.66, 10.77, 11.88, 12.53, 13.34}, steady{9.49, 10.74, 11.99, 12.72, 13.64};
  for (std::size_t k = 0; k < rigidity.size(); ++k) {
    const DeepInClay cone{rigidity[k], 0, 0};
    EXPECT_NEAR(cone_factor_strain_path(cone).value, path[k], digits);
    EXPECT_NEAR(cone_factor_remeshed(cone).value, remeshed[k], digits);
    EXPECT_NEAR(cone_factor_steady(cone).value, steady[k], digits);
  }
}

TEST(Penetrometer, roughness_and_anisotropy_change_a_cone_factor_linearly)
{
  const DeepInClay cone{100, 0, 0}, rough{100, 1, 0}, anisotropic{100, 0, 0.5};
  EXPECT_NEAR(cone_factor_strain_path(rough).value - cone_factor_strain_path(cone).value, 2.2, 1e-12);
  EXPECT_NEAR(cone_factor_remeshed(rough).value - cone_factor_remeshed(cone).value, 1.3, 1e-12);
  EXPECT_NEAR(cone_factor_strain_path(anisotropic).value - cone_factor_strain_path(cone).value, -0.9, 1e-12);
  EXPECT_NEAR(cone_factor_remeshed(anisotropic).value - cone_factor_remeshed(cone).value, -0.95, 1e-12);
  EXPECT_NEAR(cone_factor_steady(anisotropic).value - cone_factor_steady(cone).value, -1.05, 1e-12);
  EXPECT_FALSE(cone_factor_strain_path({100, nan, 0}).valid);
  EXPECT_FALSE(cone_factor_remeshed({1000, 0, 0}).valid);
}

TEST(Penetrometer, what_is_recalled_says_so)
{
  for (const Formula& formula :
       {cone_factor_strain_path({100}), cone_factor_remeshed({100}), cone_factor_steady({100}), ball_factor(0), deep_plate_factor(0)})
    EXPECT_EQ(formula.source.label, Label::recalled) << formula.source.work;
}

TEST(Penetrometer, a_smooth_sphere_goes_through_its_table)
{
  EXPECT_NEAR(smooth_sphere(0.05).value, 0.787, 1e-12);
  EXPECT_NEAR(smooth_sphere(0.1).value, 1.446, 1e-12);
  EXPECT_NEAR(smooth_sphere(0.3).value, 3.198, 1e-12);
  EXPECT_NEAR(smooth_sphere(0.5).value, 3.930, 1e-12);
  EXPECT_GT(smooth_sphere(0.2).value, 1.446);
  EXPECT_LT(smooth_sphere(0.2).value, 3.198);
  EXPECT_FALSE(smooth_sphere(0.6).valid);
}

TEST(Penetrometer, deep_factors_go_from_smooth_to_rough)
{
  EXPECT_NEAR(deep_plate_factor(0).value, 12.42, 1e-12);
  EXPECT_NEAR(deep_plate_factor(1).value, 13.11, 1e-12);
  EXPECT_NEAR(ball_factor(0).value, 11.4, 1e-12);
  EXPECT_NEAR(ball_factor(1).value, 15.2, 1e-12);
  EXPECT_FALSE(ball_factor(nan).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
