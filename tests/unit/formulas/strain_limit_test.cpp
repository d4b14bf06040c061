// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/strain_limit.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// By hand, of a wall of 15 mm and 0.4 m: 0.78 (0.0375 - 0.01) 0.93^-1.5 (1 - 0.0667) = 0.02145 * 1.11499 * 0.93333.
TEST(StrainLimit, of_a_16_inch_pipe_is_that_of_a_calculation_by_hand)
{
  const Formula limit = f101_compressive_strain(0.4, 0.015, f101_yield_over_tensile);
  EXPECT_NEAR(limit.value, 0.022322, 5e-6);
  EXPECT_TRUE(limit.valid);
  EXPECT_EQ(citation(limit.source), "DNV-OS-F101, equation 5.30, displacement controlled");
}

TEST(StrainLimit, welds_take_a_hundredth_for_each_unit_of_slenderness_beyond_20)
{
  EXPECT_EQ(f101_girth_weld_factor(0.3, 0.02), 1);
  EXPECT_EQ(f101_girth_weld_factor(0.4, 0.02), 1);
  EXPECT_NEAR(f101_girth_weld_factor(0.6, 0.02), 0.9, 1e-12);
  EXPECT_NEAR(f101_girth_weld_factor(1.2, 0.02), 0.6, 1e-12);
}

TEST(StrainLimit, is_out_of_its_range_for_slender_walls)
{
  EXPECT_TRUE(f101_compressive_strain(0.45, 0.01, 0.93).valid);
  EXPECT_FALSE(f101_compressive_strain(0.46, 0.01, 0.93).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
