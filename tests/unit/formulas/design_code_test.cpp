// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/design_code.hpp"

#include "formulas/footing.hpp"

#include <gtest/gtest.h>

namespace berm::formulas {
namespace {

constexpr Real D = 0.4;

PipeInClay clay_at(Real relative_embedment)
{
  return {.diameter = D, .embedment = D * relative_embedment, .strength = 2000, .unit_weight = 6000};
}

PipeInSand sand_at(Real relative_embedment)
{
  return {.diameter = D,
          .embedment = D * relative_embedment,
          .unit_weight = 9000,
          .friction_angle = 35 * degree,
          .interface_angle = 20 * degree};
}

Real model_1(const PipeInClay& pipe)
{
  return f114_undrained_model_1(pipe, 1).value;
}

/// Whether f(x) has no step at x = at: slopes of the order of f over 2e-9, and the arc sine of B/D near 1, which has half the digits.
template <class F>
void expect_no_step(const F& f, Real at)
{
  EXPECT_NEAR(f(at - 1e-9) / f(at + 1e-9), 1, 1e-6) << at;
}

TEST(DesignCode, width_and_area_are_those_of_a_circle_up_to_its_widest_level)
{
  EXPECT_NEAR(f114_contact_width(D, D / 4), D * std::sqrt(3.) / 2, 1e-15);
  EXPECT_NEAR(f114_penetrated_area(D, D / 4), D * D * (pi / 12 - std::sqrt(3.) / 16), 1e-15);  // segment of 120 degrees
  EXPECT_EQ(f114_contact_width(D, D), D);
  EXPECT_NEAR(f114_penetrated_area(D, D), D * D * (pi / 8 + 0.5), 1e-15);
  EXPECT_EQ(f114_contact_width(D, 0), 0);
  EXPECT_EQ(f114_penetrated_area(D, 0), 0);
  EXPECT_TRUE(std::isnan(f114_contact_width(D, -0.01)));
}

TEST(DesignCode, nothing_steps_at_half_a_diameter)
{
  expect_no_step([](Real x) { return f114_contact_width(D, D * x); }, 0.5);
  expect_no_step([](Real x) { return f114_penetrated_area(D, D * x); }, 0.5);
  expect_no_step([](Real x) { return model_1(clay_at(x)); }, 0.5);
  expect_no_step([](Real x) { return f114_undrained_model_2(clay_at(x)).value; }, 0.5);
  expect_no_step([](Real x) { return f114_drained_vertical(sand_at(x)).value; }, 0.5);
}

TEST(DesignCode, nothing_steps_where_depth_begins_to_count)
{
  expect_no_step([](Real x) { return model_1(clay_at(x)); }, 0.5 * (1 - std::sqrt(0.5)));
  expect_no_step([](Real x) { return f114_drained_vertical(sand_at(x)).value; }, 0.5 * (1 - std::cos(62.5 * degree)));
}

TEST(DesignCode, a_barely_embedded_pipe_is_a_footing_of_its_contact_width)
{
  const Real B = f114_contact_width(D, 0.1 * D);
  const Real buoyancy = 6000 * f114_penetrated_area(D, 0.1 * D);
  EXPECT_NEAR(model_1(clay_at(0.1)), (2 + pi) * 2000 * B + buoyancy, 1e-9);
  EXPECT_NEAR(f114_undrained_model_1(clay_at(0.1), 1.2).value, 1.2 * (2 + pi) * 2000 * B + buoyancy, 1e-9);
  EXPECT_NEAR(f114_drained_vertical(sand_at(0.1)).value, 0.5 * 9000 * n_gamma_hansen(35 * degree).value * B * B, 1e-9);
  EXPECT_EQ(model_1(clay_at(0)), 0);
  EXPECT_EQ(f114_drained_vertical(sand_at(0)).value, 0);
}

TEST(DesignCode, depth_adds_to_bearing_capacity_as_worked_by_hand)
{
  // w = D/2 in uniform clay: B = D, z = (D/2)(sqrt 2 - 1) = 0.2071 D, s_u1 = s_u2, d = 0.3 atan 0.2071 = 0.06127.
  EXPECT_NEAR(model_1(clay_at(0.5)) - 6000 * pi * D * D / 8, (2 + pi) * 2000 * D * 1.06127, 0.05);
  // w = D/2 in sand: z0 = (D/2)(1/sin 62.5 - 1) tan 62.5 = 0.12234 D; d_q = 1 + 1.2 x 0.12234 x 0.70021 x 0.18183 = 1.01869.
  const Real deep = 0.12234 * 33.296 * 1.01869;
  EXPECT_NEAR(f114_drained_vertical(sand_at(0.5)).value / (9000 * D * D), 0.5 * 33.921 + deep, 0.005);
}

TEST(DesignCode, strength_that_grows_with_depth_is_taken_where_it_acts)
{
  // w = 0.1 D: z = 0, so that the surface strength 1900 Pa counts: Q_v0 = (N_c 1900 + 2500 B/4) B, with B = 0.6 D = 0.24 m.
  PipeInClay pipe = clay_at(0.1);
  pipe.strength_gradient = 2500;
  pipe.unit_weight = 0;
  EXPECT_NEAR(model_1(pipe), ((2 + pi) * 1900 + 2500 * 0.24 / 4) * 0.24, 1e-9);
}

TEST(DesignCode, growing_strength_counts_at_depth_as_worked_by_hand)
{
  // w = D/2 = 0.2 m, 5000 Pa/m: 1000 Pa at the surface, z = 0.2 (sqrt 2 - 1) = 0.0828427 m, s_u0 = 1414.214, s_u1 = 1207.107,
  // s_u2 = 1414.214 + 5000 x 0.4/(4 x 5.14159) = 1511.459, d = 0.3 x 1207.107/1511.459 x atan 0.2071068 = 0.0489292.
  PipeInClay pipe = clay_at(0.5);
  pipe.strength_gradient = 5000;
  pipe.unit_weight = 0;
  EXPECT_NEAR(model_1(pipe), (2 + pi) * 1511.459 * 0.4 * 1.0489292, 0.01);
}

TEST(DesignCode, a_pushed_pipe_meets_the_smaller_of_two_powers_and_its_buoyancy)
{
  EXPECT_NEAR(f114_undrained_model_2(clay_at(0.5)).value, 6 * std::pow(0.5, 0.25) * D * 2000 + 1.5 * 6000 * pi * D * D / 8, 1e-9);
  PipeInClay shallow = clay_at(0.01);
  shallow.unit_weight = 0;
  EXPECT_NEAR(f114_undrained_model_2(shallow).value, 3.4 * std::sqrt(0.1) * D * 2000, 1e-9);
}

TEST(DesignCode, drained_lateral_resistance_is_passive_pressure_and_friction)
{
  const Real K_p = 3.69017, F_p = 0.5 * K_p * 9000 * 0.04 * 0.04, t = std::tan(20 * degree);
  EXPECT_NEAR(f114_drained_lateral(sand_at(0.1), 1000).value, F_p + t * (1000 - t * F_p), 1e-3);
  EXPECT_NEAR(f114_drained_lateral(sand_at(0.1), 0).value, F_p, 1e-3);
  EXPECT_NEAR(f114_drained_lateral(sand_at(0), 1000).value, 1000 * t, 1e-9);
}

TEST(DesignCode, breakout_lies_within_its_range)
{
  const Breakout breakout = f114_breakout(D, 0.2 * D);
  EXPECT_NEAR(breakout.min.value, D * 0.008, 1e-15);
  EXPECT_NEAR(breakout.mean.value, D * 0.07, 1e-15);
  EXPECT_NEAR(breakout.max.value, D * 0.24, 1e-15);
  EXPECT_TRUE(breakout.mean.valid);
}

TEST(DesignCode, values_out_of_range_are_told)
{
  EXPECT_TRUE(f114_undrained_model_1(clay_at(1), 1).valid);
  EXPECT_FALSE(f114_undrained_model_1(clay_at(1.1), 1).valid);
  EXPECT_TRUE(std::isnan(model_1(clay_at(-0.1))));
  EXPECT_TRUE(f114_undrained_model_2(clay_at(0.5)).valid);
  EXPECT_FALSE(f114_undrained_model_2(clay_at(0.6)).valid);
  EXPECT_TRUE(f114_drained_vertical(sand_at(0.5)).valid);
  EXPECT_FALSE(f114_drained_vertical(sand_at(1.1)).valid);
  PipeInSand loose = sand_at(0.5);
  loose.friction_angle = 10 * degree;
  EXPECT_FALSE(f114_drained_vertical(loose).valid);
  EXPECT_FALSE(f114_drained_lateral(sand_at(0.1), -1).valid);
  EXPECT_FALSE(f114_breakout(D, 1.1 * D).mean.valid);
  PipeInClay growing = clay_at(0.5);
  growing.strength_gradient = 2000 / (0.5 * D);  // from nothing at the surface
  EXPECT_TRUE(f114_undrained_model_1(growing, 1).valid);
  growing.strength_gradient = 20e3;  // the surface would have a negative strength
  EXPECT_FALSE(f114_undrained_model_1(growing, 1).valid);
}

}  // namespace
}  // namespace berm::formulas
