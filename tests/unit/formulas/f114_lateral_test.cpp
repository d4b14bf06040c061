// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/f114.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

constexpr Real D = 0.4;

PipeInClay clay_at(Real relative_embedment, Real roughness = 0)
{
  return {.diameter = D, .embedment = D * relative_embedment, .strength = 2000, .roughness = roughness, .unit_weight = 6000};
}

PipeInSand sand_at(Real relative_embedment)
{
  return {.diameter = D,
          .embedment = D * relative_embedment,
          .unit_weight = 9000,
          .friction_angle = 35 * degree,
          .interface_angle = 20 * degree};
}

TEST(F114Lateral, undrained_model_1_is_pressure_on_the_embedded_height_and_friction_over_the_contact)
{
  // Defaults of Sivamanikantakumar122's psi_backend.py, by its formula: z (2 s_u + gamma' z/2) = 0.1 (2 x 5 + 0.5 x 7.95 x 0.1) = 1.03975 kN/m.
  const PipeInClay its{.diameter = 0.4, .embedment = 0.1, .strength = 5000, .unit_weight = 7950};
  EXPECT_NEAR(f114_undrained_lateral_1(its, Rear::gap).low.value, 1039.75, 1e-9);
  // SarahCMartin/WSP_PSI: pressure coefficients from 2 to 2.5, its own 2.25; with suction active and passive side add up.
  const Estimates gap = f114_undrained_lateral_1(clay_at(0.5), Rear::gap), suction = f114_undrained_lateral_1(clay_at(0.5), Rear::suction);
  EXPECT_NEAR(gap.best.value, 0.2 * (2.25 * 2000 + 600), 1e-9);
  EXPECT_NEAR(gap.high.value, 0.2 * (2.5 * 2000 + 600), 1e-9);
  EXPECT_NEAR(suction.low.value, 0.2 * 4 * 2000, 1e-9);
  EXPECT_NEAR(suction.high.value, 0.2 * 5 * 2000, 1e-9);
  const Real friction =
      f114_undrained_lateral_1(clay_at(0.25, 0.5), Rear::gap).best.value - f114_undrained_lateral_1(clay_at(0.25), Rear::gap).best.value;
  EXPECT_NEAR(friction, 0.5 * 2000 * f114_contact_width(D, 0.25 * D), 1e-9);
}

TEST(F114Lateral, undrained_model_1_takes_the_strength_at_half_of_the_height_and_no_more_than_a_diameter)
{
  PipeInClay growing = clay_at(0.5);
  growing.strength_gradient = 5000;  // 2000 Pa at the invert, 1500 Pa at half of 0.2 m
  EXPECT_NEAR(f114_undrained_lateral_1(growing, Rear::suction).low.value, 0.2 * 4 * 1500, 1e-9);
  EXPECT_TRUE(f114_undrained_lateral_1(growing, Rear::gap).best.valid);
  growing.strength_gradient = 20e3;
  EXPECT_FALSE(f114_undrained_lateral_1(growing, Rear::gap).best.valid) << "less than nothing at the surface";
  EXPECT_NEAR(f114_undrained_lateral_1(clay_at(1.5), Rear::suction).low.value, D * 4 * 2000, 1e-9);
  EXPECT_FALSE(f114_undrained_lateral_1(clay_at(1.5), Rear::gap).best.valid);
  EXPECT_FALSE(f114_undrained_lateral_1(clay_at(0.5, nan), Rear::gap).best.valid) << "the interface has friction";
  EXPECT_EQ(f114_undrained_lateral_1(clay_at(0, 1), Rear::gap).high.value, 0) << "a pipe that only touches";
}

TEST(F114Lateral, undrained_model_2_is_that_of_a_public_program)
{
  // stucharo/PSI, tests/test_PSI_Clay_Calc.py, from a sheet of hand calculation beside it: 3.0246474 times a weight of 5000 N/m, under Q_v = 100 kN/m.
  const PipeInClay pipe{.diameter = 1, .embedment = 0.1, .strength = 4000, .unit_weight = 2500 * 9.80665};
  EXPECT_NEAR(f114_undrained_lateral_2(pipe, 1e5).value / 5000, 3.0246474, 1e-6);
  // Without a load and without weight: 1.7 x 0.25^0.61 D s_u.
  PipeInClay weightless = clay_at(0.25);
  weightless.unit_weight = 0;
  EXPECT_NEAR(f114_undrained_lateral_2(weightless, 0).value, 1.7 * 0.429283 * 800, 0.01);
  EXPECT_FALSE(f114_undrained_lateral_2(clay_at(0.25), -1).valid);
  EXPECT_FALSE(f114_undrained_lateral_2(clay_at(1.1), 100).valid);
}

TEST(F114Lateral, both_undrained_models_scale_with_length_and_strength)
{
  // Lengths times 3 and strengths times 5 (unit weight times 5/3, V times 15): forces times 15.
  const PipeInClay large{.diameter = 3 * D, .embedment = 0.9 * D, .strength = 10e3, .roughness = 0.4, .unit_weight = 10e3};
  const PipeInClay small = clay_at(0.3, 0.4);
  EXPECT_NEAR(f114_undrained_lateral_1(large, Rear::gap).best.value / f114_undrained_lateral_1(small, Rear::gap).best.value, 15, 1e-9);
  EXPECT_NEAR(f114_undrained_lateral_2(large, 15 * 700).value / f114_undrained_lateral_2(small, 700).value, 15, 1e-9);
}

TEST(F114Lateral, drained_resistance_is_passive_pressure_and_friction)
{
  // K_p of 20 degrees is 2.03961, of 35 degrees 3.69017.
  const Real t = std::tan(20 * degree);
  for (const auto& [angle, K_p] : {std::pair{PassiveAngle::interface, 2.03961}, std::pair{PassiveAngle::soil, 3.69017}}) {
    const Real F_p = 0.5 * K_p * 9000 * 0.04 * 0.04;
    EXPECT_NEAR(f114_drained_lateral(sand_at(0.1), 1000, angle).value, F_p + t * (1000 - t * F_p), 1e-3);
    EXPECT_NEAR(f114_drained_lateral(sand_at(0.1), 0, angle).value, F_p, 1e-3);
    EXPECT_NEAR(f114_drained_lateral(sand_at(0), 1000, angle).value, 1000 * t, 1e-9);
  }
  EXPECT_FALSE(f114_drained_lateral(sand_at(0.1), -1).valid);
}

TEST(F114Lateral, only_the_reading_of_the_passive_coefficient_that_a_public_program_has_may_be_shown)
{
  EXPECT_EQ(f114_drained_lateral(sand_at(0.1), 100).source.label, Label::fit);
  EXPECT_EQ(f114_drained_lateral(sand_at(0.1), 100, PassiveAngle::soil).source.label, Label::recalled);
  EXPECT_GT(f114_drained_lateral(sand_at(0.5), 100, PassiveAngle::soil).value, f114_drained_lateral(sand_at(0.5), 100).value);
}

TEST(F114Lateral, residual_estimates_lie_half_as_far_again_to_either_side)
{
  const Estimates H = f114_clay_residual(clay_at(0.25), 1000);
  EXPECT_NEAR(H.best.value, 1000 * (0.32 + 0.8 * 0.32988), 0.01);  // 0.25^0.8 = 0.32988
  EXPECT_NEAR(H.low.value * 1.5, H.best.value, 1e-9);
  EXPECT_NEAR(H.high.value / 1.5, H.best.value, 1e-9);
  EXPECT_TRUE(H.low.valid);
  EXPECT_FALSE(f114_clay_residual(clay_at(0.25), -1).low.valid) << "a pipe that floats has no friction";
  EXPECT_FALSE(f114_clay_residual(clay_at(0.25), 1601).low.valid) << "a heavy pipe does not rise from where it broke out: V > 2 D s_u";
}

TEST(F114Lateral, displacements_are_those_of_the_tables)
{
  const Estimates breakout = f114_breakout_displacement(D, 0.2 * D), residual = f114_residual_displacement(D);
  EXPECT_NEAR(breakout.low.value, D * 0.008, 1e-15);
  EXPECT_NEAR(breakout.best.value, D * 0.07, 1e-15);
  EXPECT_NEAR(breakout.high.value, D * 0.24, 1e-15);
  EXPECT_TRUE(breakout.best.valid);
  EXPECT_FALSE(f114_breakout_displacement(D, 1.1 * D).best.valid);
  EXPECT_NEAR(residual.low.value, 0.6 * D, 1e-15);
  EXPECT_NEAR(residual.best.value, 1.5 * D, 1e-15);
  EXPECT_NEAR(residual.high.value, 2.8 * D, 1e-15);
  for (const Real w : {0., 0.5, 1.})
    EXPECT_LT(f114_breakout_displacement(D, w * D).high.value, residual.best.value) << "breakout comes first";
}

TEST(F114Lateral, work_edition_and_clause_are_told)
{
  EXPECT_EQ(citation(f114_undrained_lateral_2(clay_at(0.2), 100).source), "DNV-RP-F114 (2021), equation 4.22");
  EXPECT_EQ(citation(f114_undrained_lateral_1(clay_at(0.2), Rear::gap).best.source), "DNVGL-RP-F114, 4.4.2.2");
  EXPECT_EQ(citation(f114_residual_displacement(D).best.source), "DNVGL-RP-F114, table 4-5");
  EXPECT_EQ(citation(f114_clay_residual(clay_at(0.2), 100).best.source), "DNV-RP-F114") << "no public source states the clause";
}

// By hand: w = 0.2 D, s_u = 2 kPa + 1.5 kPa/m z, 2.12 kPa at the invert and 2.06 kPa at half of that depth, B = 0.32 m, r = 0.5, V = 1.2 kN/m.
// Model 1: 0.5 x 2120 x 0.32 + 0.08 (2.25 x 2060 + 6000 x 0.04). Model 2: 848 (1.7 x 0.2^0.61 + 0.23 (1200/848)^0.83) + 0.6 x 6000 x 0.08^2.
TEST(F114Lateral, of_a_flowline_is_that_of_a_hand_check)
{
  PipeInClay flowline = clay_at(0.2, 0.5);
  flowline.strength = 2120, flowline.strength_gradient = 1500;
  EXPECT_NEAR(f114_undrained_lateral_1(flowline, Rear::gap).best.value, 339.2 + 390, 1e-9);
  EXPECT_NEAR(f114_undrained_lateral_2(flowline, 1200).value, 823.320, 1e-3);
}

}  // namespace
}  // namespace berm::formulas::this_file
