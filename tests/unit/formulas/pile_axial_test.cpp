// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pile_axial.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

TEST(PileAxial, friction_in_clay_has_the_alpha_of_the_strength_ratio)
{
  EXPECT_NEAR(api_clay_friction(50e3, 50e3).value, 25e3, 1e-9);
  EXPECT_NEAR(api_clay_friction(25e3, 100e3).value, 25e3, 1e-9) << "psi = 0.25: alpha = 1";
  EXPECT_NEAR(api_clay_friction(10e3, 100e3).value, 10e3, 1e-9) << "at most 1";
  EXPECT_NEAR(api_clay_friction(160e3, 10e3).value, 40e3, 1e-9) << "psi = 16: alpha = 0.25";
  EXPECT_FALSE(api_clay_friction(160e3, 10e3).valid);
}

TEST(PileAxial, sand_has_a_table_by_the_angle_of_the_interface)
{
  EXPECT_NEAR(api_sand_friction(100e3, 30 * degree, true).value, 57.735e3, 1);
  EXPECT_NEAR(api_sand_friction(100e3, 30 * degree, false).value, 0.8 * 57.735e3, 1);
  EXPECT_NEAR(api_sand_friction(300e3, 30 * degree, true).value, 95.7e3, 1e-6) << "its limit";
  EXPECT_NEAR(api_sand_base(100e3, 30 * degree).value, 4e6, 1e-3);
  EXPECT_NEAR(api_sand_base(100e3, 27.5 * degree).value, 3e6, 1e-3) << "straight between";
  EXPECT_NEAR(api_sand_base(1e6, 35 * degree).value, 12e6, 1e-3);
  EXPECT_FALSE(api_sand_base(1e6, 10 * degree).valid);
  EXPECT_NEAR(api_clay_base(30e3).value, 270e3, 1e-9);
}

TEST(PileAxial, displacements_mobilise_as_in_the_tables)
{
  EXPECT_EQ(api_clay_friction_share(0, 2), 0);
  EXPECT_NEAR(api_clay_friction_share(0.0031 * 2, 2), 0.5, 1e-12);
  EXPECT_NEAR(api_clay_friction_share(0.01 * 2, 2), 1, 1e-12);
  EXPECT_NEAR(api_clay_friction_share(1, 2), 0.9, 1e-12);
  EXPECT_NEAR(api_sand_friction_share(1.27e-3), 0.5, 1e-12);
  EXPECT_NEAR(api_sand_friction_share(1), 1, 1e-12);
  EXPECT_NEAR(api_base_share(0.013 * 2, 2), 0.5, 1e-12);
  EXPECT_NEAR(api_base_share(0.2, 2), 1, 1e-12);
}

}  // namespace
}  // namespace berm::formulas::this_file
