// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/f114.hpp"

#include "formulas/footing.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
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
  return f114_undrained_model_1(pipe).value;
}

/// Whether f(x) has no step at x = at: slopes of the order of f over 2e-9, and the arc sine of B/D near 1, which has half the digits.
template <class F>
void expect_no_step(const F& f, Real at)
{
  EXPECT_NEAR(f(at - 1e-9) / f(at + 1e-9), 1, 1e-6) << at;
}

TEST(F114Vertical, width_and_area_are_those_of_a_circle_up_to_its_widest_level)
{
  EXPECT_NEAR(f114_contact_width(D, D / 4), D * std::sqrt(3.) / 2, 1e-15);
  EXPECT_NEAR(f114_penetrated_area(D, D / 4), D * D * (pi / 12 - std::sqrt(3.) / 16), 1e-15);  // segment of 120 degrees
  EXPECT_EQ(f114_contact_width(D, D), D);
  EXPECT_NEAR(f114_penetrated_area(D, D), D * D * (pi / 8 + 0.5), 1e-15);
  EXPECT_EQ(f114_contact_width(D, 0), 0);
  EXPECT_EQ(f114_penetrated_area(D, 0), 0);
  EXPECT_TRUE(std::isnan(f114_contact_width(D, -0.01)));
}

TEST(F114Vertical, nothing_steps_at_half_a_diameter)
{
  expect_no_step([](Real x) { return f114_contact_width(D, D * x); }, 0.5);
  expect_no_step([](Real x) { return f114_penetrated_area(D, D * x); }, 0.5);
  expect_no_step([](Real x) { return model_1(clay_at(x)); }, 0.5);
  expect_no_step([](Real x) { return f114_undrained_model_2(clay_at(x)).value; }, 0.5);
  expect_no_step([](Real x) { return f114_drained_vertical(sand_at(x)).value; }, 0.5);
}

TEST(F114Vertical, nothing_steps_where_depth_begins_to_count)
{
  expect_no_step([](Real x) { return model_1(clay_at(x)); }, 0.5 * (1 - std::sqrt(0.5)));
  expect_no_step([](Real x) { return f114_drained_vertical(sand_at(x)).value; }, 0.5 * (1 - std::cos(62.5 * degree)));
}

TEST(F114Vertical, a_barely_embedded_pipe_is_a_footing_of_its_contact_width)
{
  const Real B = f114_contact_width(D, 0.1 * D);
  const Real buoyancy = 6000 * f114_penetrated_area(D, 0.1 * D);
  EXPECT_NEAR(model_1(clay_at(0.1)), (2 + pi) * 2000 * B + buoyancy, 1e-9);
  EXPECT_NEAR(f114_undrained_model_1(clay_at(0.1), 6).value, 6 * 2000 * B + buoyancy, 1e-9) << "with another N_c";
  EXPECT_NEAR(f114_drained_vertical(sand_at(0.1)).value, 0.5 * 9000 * n_gamma_hansen(35 * degree).value * B * B, 1e-9);
  EXPECT_EQ(model_1(clay_at(0)), 0);
  EXPECT_EQ(f114_drained_vertical(sand_at(0)).value, 0);
}

TEST(F114Vertical, depth_adds_to_bearing_capacity_as_worked_by_hand)
{
  // w = D/2 in uniform clay: B = D, z = (D/2)(sqrt 2 - 1) = 0.2071 D, s_u1 = s_u2, d = 0.3 atan 0.2071 = 0.06127.
  EXPECT_NEAR(model_1(clay_at(0.5)) - 6000 * pi * D * D / 8, (2 + pi) * 2000 * D * 1.06127, 0.05);
  // w = D/2 in sand: z0 = (D/2)(1/sin 62.5 - 1) tan 62.5 = 0.12234 D; d_q = 1 + 1.2 x 0.12234 x 0.70021 x 0.18183 = 1.01869.
  const Real deep = 0.12234 * 33.296 * 1.01869;
  EXPECT_NEAR(f114_drained_vertical(sand_at(0.5)).value / (9000 * D * D), 0.5 * 33.921 + deep, 0.005);
}

TEST(F114Vertical, strength_that_grows_with_depth_is_taken_where_it_acts)
{
  // w = 0.1 D: z = 0, so that the surface strength 1900 Pa counts: Q_v0 = (N_c 1900 + 2500 B/4) B, with B = 0.6 D = 0.24 m.
  PipeInClay pipe = clay_at(0.1);
  pipe.strength_gradient = 2500;
  pipe.unit_weight = 0;
  const Real F = f114_strength_factor(2500 * 0.24 / 1900, 0).value;
  EXPECT_NEAR(model_1(pipe), F * ((2 + pi) * 1900 + 2500 * 0.24 / 4) * 0.24, 1e-9);
}

TEST(F114Vertical, growing_strength_counts_at_depth_as_worked_by_hand)
{
  // w = D/2 = 0.2 m, 5000 Pa/m: 1000 Pa at the surface, z = 0.2 (sqrt 2 - 1) = 0.0828427 m, s_u0 = 1414.214, s_u1 = 1207.107,
  // x = 5000 x 0.4/1414.214 = 1.414214, F = 1.110 + 0.071 ln(2.414214/2)/ln(3/2) = 1.142956 (smooth),
  // s_u2 = F (1414.214 + 5000 x 0.4/(4 x 5.141593)) = 1727.532, d = 0.3 x 1207.107/1727.532 x atan 0.2071068 = 0.0428093.
  PipeInClay pipe = clay_at(0.5);
  pipe.strength_gradient = 5000;
  pipe.unit_weight = 0;
  EXPECT_NEAR(model_1(pipe), (2 + pi) * 1727.532 * 0.4 * 1.0428093, 0.05);
}

TEST(F114Vertical, a_pushed_pipe_meets_the_smaller_of_two_powers_and_its_buoyancy)
{
  EXPECT_NEAR(f114_undrained_model_2(clay_at(0.5)).value, 6 * std::pow(0.5, 0.25) * D * 2000 + 1.5 * 6000 * pi * D * D / 8, 1e-9);
  PipeInClay shallow = clay_at(0.01);
  shallow.unit_weight = 0;
  EXPECT_NEAR(f114_undrained_model_2(shallow).value, 3.4 * std::sqrt(0.1) * D * 2000, 1e-9);
}

TEST(F114Vertical, the_factor_for_growing_strength_is_that_of_the_figure)
{
  // Figure 4-4 as snakesonabrain/groundhog read it off: x, smooth or rough, F. Off the exact solutions, which are taken up to x = 8, by the reading and by the straight
  // lines of ln(1 + x) between them: 1.3 % at most.
  const Real figure[][3] = {{0.6331, 0, 1.0749}, {2.0161, 0, 1.1865}, {5.9985, 0, 1.3342}, {12.469, 0, 1.4189},
                            {0.4534, 1, 1.1074}, {2.0447, 1, 1.3562}, {6.9141, 1, 1.6102}, {12.386, 1, 1.7036}};
  for (const auto& [x, roughness, F] : figure) EXPECT_NEAR(f114_strength_factor(x, roughness).value / F, 1, 0.014) << x << ' ' << roughness;
  EXPECT_EQ(f114_strength_factor(0, nan).value, 1) << "uniform strength: whatever the interface";
  EXPECT_NEAR(f114_strength_factor(4, 0).value, 1.273, 1e-12);
  EXPECT_NEAR(f114_strength_factor(4, 0.5).value, (1.273 + 1.486) / 2, 1e-12);
  Real before = 1;
  for (Real x = 0.25; x <= 16; x += 0.25) {
    const Formula F = f114_strength_factor(x, 1);
    EXPECT_TRUE(F.valid);
    EXPECT_GT(F.value, before);
    before = F.value;
  }
  EXPECT_FALSE(f114_strength_factor(17, 0).valid);
  EXPECT_FALSE(f114_strength_factor(-0.1, 0).valid);
}

// stucharo/PSI, tests/test_PSI_Clay_Calc.py, whose numbers are from sheets of hand calculation beside it.
TEST(F114Vertical, model_2_and_its_geometry_are_those_of_a_public_program)
{
  EXPECT_NEAR(f114_contact_width(1, 0.1), 0.6, 1e-12);
  EXPECT_NEAR(f114_penetrated_area(1, 0.1), 0.040875, 1e-6);
  EXPECT_NEAR(f114_penetrated_area(1, 0.6), 0.492699, 1e-6);
  const Real rows[][5] = {{400, 1, 0.1, 1000, 3614.55767342},
                          {500, 0.8, 0.5, 2000, 10972.65014397},
                          {600, 1.2, 0.12, 3000, 12666.0736242},
                          {1000, 0.1, 0.01, 4000, 1355.6319235}};  // density in kg/m3, D, w, s_u, Q_v
  for (const auto& [density, diameter, w, s_u, Q_v] : rows)
    EXPECT_NEAR(f114_undrained_model_2({.diameter = diameter, .embedment = w, .strength = s_u, .unit_weight = density * 9.80665}).value,
                Q_v, 1e-4);
}

// snakesonabrain/groundhog, tests of pipelinescables/stability/penetration.py, in kN.
TEST(F114Vertical, all_models_are_those_of_another_public_program)
{
  PipeInClay pipe{.diameter = 1, .embedment = 0.5, .strength = 2000, .unit_weight = 3000};
  EXPECT_NEAR(f114_undrained_model_2(pipe).value, 11.86e3, 5);
  // Q_v0 = 28.17 kN/m for 5 kPa at the surface and 1 kPa/m, roughness 0.67; what berm gives has depth and buoyancy too. d = 0.3 (s_u1/s_u2) atan 0.20711.
  pipe = {.diameter = 1, .embedment = 0.5, .strength = 5500, .roughness = 0.67, .strength_gradient = 1000, .unit_weight = 4000};
  const Real Q_v0 = f114_undrained_model_1(pipe, 5.14).value - 4000 * pi / 8 - 0.3 * 5103.55 * 5.14 * std::atan(0.207107);
  EXPECT_NEAR(Q_v0 / 28.17e3, 1, 0.006) << "F is exact here and read off a figure there";
  const PipeInSand sand{.diameter = 0.5, .embedment = 0.1, .unit_weight = 8000, .friction_angle = 35 * degree};
  EXPECT_NEAR(f114_drained_vertical(sand, SelfWeight::vesic).value, 30.74e3, 5);
  EXPECT_NEAR(f114_drained_vertical(sand).value / f114_drained_vertical(sand, SelfWeight::vesic).value,
              n_gamma_hansen(35 * degree).value / n_gamma_vesic(35 * degree).value, 1e-12)
      << "no depth factor yet";
}

TEST(F114Vertical, values_out_of_range_are_told)
{
  EXPECT_TRUE(f114_undrained_model_1(clay_at(1)).valid);
  EXPECT_FALSE(f114_undrained_model_1(clay_at(1.1)).valid);
  EXPECT_TRUE(std::isnan(model_1(clay_at(-0.1))));
  EXPECT_TRUE(f114_undrained_model_2(clay_at(0.5)).valid);
  EXPECT_FALSE(f114_undrained_model_2(clay_at(0.6)).valid);
  EXPECT_TRUE(f114_drained_vertical(sand_at(0.5)).valid);
  EXPECT_FALSE(f114_drained_vertical(sand_at(1.1)).valid);
  PipeInSand loose = sand_at(0.5);
  loose.friction_angle = 10 * degree;
  EXPECT_FALSE(f114_drained_vertical(loose).valid);
  PipeInClay growing = clay_at(0.5);
  growing.strength_gradient = 2000 / (0.5 * D);  // from nothing at the surface
  EXPECT_TRUE(f114_undrained_model_1(growing).valid);
  growing.strength_gradient = 20e3;  // the surface would have a negative strength
  EXPECT_FALSE(f114_undrained_model_1(growing).valid);
}

// By hand: D = 0.5 m, w = 0.1 D, s_u = 2.296 kPa there, 6 kN/m3: 6 x 0.1^0.25 = 3.37405 < 3.4, sin a = B/D = 0.6, a = 0.643501, A_bm = 0.0102188 m2.
// Model 2: 3.37405 x 0.5 x 2.296 + 1.5 x 6 x 0.0102188 = 3.8734 + 0.0920 kN/m.
TEST(F114Vertical, model_2_of_a_pipe_below_a_sounding_is_that_of_a_hand_check)
{
  const PipeInClay pipe{.diameter = 0.5, .embedment = 0.05, .strength = 2296, .strength_gradient = 3600, .unit_weight = 6000};
  EXPECT_NEAR(f114_undrained_model_2(pipe).value, 3965.38, 0.01);
}

}  // namespace
}  // namespace berm::formulas::this_file
