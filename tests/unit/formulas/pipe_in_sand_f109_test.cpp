// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

PipeInSand sand_at(Real relative_embedment)
{
  return {.diameter = 0.02, .embedment = 0.02 * relative_embedment, .unit_weight = 430e3, .friction_angle = 35 * degree};
}

constexpr Real weight = 430e3 * 0.02 * 0.02;

TEST(F109, a_light_pipe_has_less_passive_resistance_for_its_weight)
{
  const Real deep = std::pow(0.2, 1.25);
  EXPECT_NEAR(f109_sand_lateral(sand_at(0.2), weight / 10).value, weight / 10 * (0.6 + (50 - 15) * deep), 1e-10);
  EXPECT_NEAR(f109_sand_lateral(sand_at(0.2), weight / 27).value, weight / 27 * (0.6 + 2 * 27 * deep), 1e-10);
  EXPECT_NEAR(f109_sand_lateral(sand_at(0.2), 0).value, 2 * weight * deep, 1e-10);
  EXPECT_DOUBLE_EQ(f109_sand_lateral(sand_at(0), 100).value, 60);
  EXPECT_FALSE(f109_sand_lateral(sand_at(0.2), -1).valid);
  EXPECT_TRUE(std::isnan(f109_sand_lateral(sand_at(-0.2), 100).value));
}

TEST(F109, the_two_branches_of_passive_resistance_meet)
{
  const Real heavy = f109_sand_lateral(sand_at(0.2), weight / (20 - 1e-9)).value,
             light = f109_sand_lateral(sand_at(0.2), weight / (20 + 1e-9)).value;
  EXPECT_NEAR(heavy / light, 1, 1e-9);  // 5 - 0.15 x 20 = 2
}

// superman1408/seawater_outflow, Operation_ContentFilled.py: for its inputs (3.4 m, 13.5 kN/m3, a weight of 49.408 kN/m) it finds, rounded to 1 mm and 1 N/m,
// an initial penetration of 0.058 m and a passive resistance of 4.355 kN/m.
TEST(F109, is_that_of_a_public_program)
{
  PipeInSand pipe{.diameter = 3.4, .embedment = 0.058, .unit_weight = 13.5e3, .friction_angle = 30 * degree};
  const Real V = 49407.9;
  EXPECT_NEAR(sand_embedment(pipe, V).value, 0.058, 5e-4);
  EXPECT_NEAR(f109_sand_lateral(pipe, V).value - 0.6 * V, 4355, 1) << "its k is rounded to three digits";
}

}  // namespace
}  // namespace berm::formulas::this_file
