// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/on_bottom_stability.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

TEST(F109PeakLoads, are_those_of_the_table_and_straight_between_its_entries)
{
  EXPECT_DOUBLE_EQ(f109_peak_loads(5, 0.3).horizontal.value, 4.32);  // superman1408/seawater_outflow: 4.32 and 3.25
  EXPECT_DOUBLE_EQ(f109_peak_loads(5, 0.3).vertical.value, 3.25);
  EXPECT_NEAR(f109_peak_loads(15, 0.15).horizontal.value, (3.72 + 3.15 + 2.72 + 2.30) / 4, 1e-12);
  EXPECT_NEAR(f109_peak_loads(120, 0).vertical.value, (1.26 + 1.05) / 2, 1e-12);
}

TEST(F109PeakLoads, of_short_oscillations_grow_across_and_of_long_ones_stay)
{
  EXPECT_DOUBLE_EQ(f109_peak_loads(1.25, 0).horizontal.value, 26);
  EXPECT_DOUBLE_EQ(f109_peak_loads(1.25, 0).vertical.value, 5);
  EXPECT_DOUBLE_EQ(f109_peak_loads(500, 20).horizontal.value, 1);
  EXPECT_DOUBLE_EQ(f109_peak_loads(500, 20).vertical.value, 0.9);
  EXPECT_FALSE(f109_peak_loads(0, 0).horizontal.valid);
  EXPECT_FALSE(f109_peak_loads(1, 20).horizontal.valid) << "a current with hardly a wave";
}

TEST(F109PeakLoads, become_less_with_the_current_at_the_same_velocity)
{
  for (const Real K : {2.5, 7., 33., 140.})
    for (Real M = 0.05; M < 10; M += 0.35) {
      EXPECT_LE(f109_peak_loads(K, M + 0.35).vertical.value, f109_peak_loads(K, M).vertical.value + 1e-12) << K << " " << M;
    }
}

// superman1408/seawater_outflow, Operation_ContentFilled.py: 0.058 m in 3.4 m, a trench of 3.5 m and 45 deg: 0.539 in a trench across, 0.307 up, by its formulas.
TEST(F109LoadReductions, are_those_of_a_public_program)
{
  const LoadReductions left = f109_load_reductions(0.058 / 3.4, 3.5 / 3.4, 45 * degree, true);
  const Real across = 1 - 0.18 * std::pow(40., 0.25) * std::pow(3.5 / 3.4, 0.42),
             up = 1 - 0.14 * std::pow(40., 0.43) * std::pow(3.5 / 3.4, 0.46);
  EXPECT_NEAR(left.horizontal.value, (1 - 1.4 * 0.058 / 3.4) * across, 1e-12);
  EXPECT_NEAR(left.vertical.value, 0.7 * up, 1e-12);
}

TEST(F109LoadReductions, have_their_limits)
{
  EXPECT_DOUBLE_EQ(f109_load_reductions(0, 0, 0, false).horizontal.value, 1);
  EXPECT_DOUBLE_EQ(f109_load_reductions(0.09, 0, 0, false).vertical.value, 1);
  EXPECT_DOUBLE_EQ(f109_load_reductions(0.9, 0, 0, false).horizontal.value, 0.3);
  EXPECT_DOUBLE_EQ(f109_load_reductions(0.9, 0, 0, false).vertical.value, 0);
  EXPECT_FALSE(f109_load_reductions(0.1, 1, 60 * degree, false).vertical.valid);
}

TEST(F109Weight, of_half_a_diameter_is_between_its_tables)
{
  EXPECT_DOUBLE_EQ(f109_weight_for_half_diameter(20, 0.6, 0.01).value, 2.18 * 2.6 * 2.6);
  EXPECT_DOUBLE_EQ(f109_weight_for_half_diameter(5, 1, 0.006).value, 3.5 * 9);
  EXPECT_NEAR(f109_weight_for_half_diameter(7.5, 0.2, 0.012).value, (1.34 + 1.50) / 2 * 2.2 * 2.2, 1e-12);
  EXPECT_DOUBLE_EQ(f109_weight_for_half_diameter(20, 0, 0.01).value, 1.35 * 4) << "M of the table is 0.2 at least";
  EXPECT_FALSE(f109_weight_for_half_diameter(5, 1, 0.1).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
