// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_answer.hpp"

#include "formulas/axial.hpp"
#include "formulas/f114.hpp"
#include "sample_route.hpp"

#include <gtest/gtest.h>

namespace berm::route::this_file {
namespace {

// By an independent program of the formulas: F114's embedment by bisection, both lateral models, five soils one at a time. Six digits there, tolerances of four.
TEST(RouteAnswer, of_clay_is_that_of_the_formulas_over_low_best_and_high_of_the_soil)
{
  const Resistances soil = answer_of(sample_route(), no_run).front().soil;
  EXPECT_EQ(soil.V, 900);
  EXPECT_NEAR(soil.embedment.best, 0.136846, 1e-5) << "laid with twice 700 N/m in remoulded clay, deeper than flooded (0.01018 m)";
  EXPECT_NEAR(soil.embedment.low, 0.060999, 1e-5);
  EXPECT_NEAR(soil.embedment.high, 0.192367, 1e-5);
  EXPECT_NEAR(soil.stiffness.best, 900 / 0.136846, 1);
  EXPECT_NEAR(soil.lateral_breakout.best, 1047.05, 0.1) << "model 1";
  EXPECT_NEAR(soil.lateral_breakout.low, 772.37, 0.1);
  EXPECT_NEAR(soil.lateral_breakout.high, 1172.93, 0.1);
  EXPECT_NEAR(soil.lateral_residual.best, 649.40, 0.1);
  EXPECT_NEAR(soil.lateral_residual.low, 318.23, 0.1);
  EXPECT_NEAR(soil.axial_breakout.best, 210.46, 0.05) << "0.5 x 0.35 x (1250/900)^0.5 x 1.25986 x 0.9 x 900 N/m";
  EXPECT_NEAR(soil.axial_breakout.low, 150.33, 0.05);
  EXPECT_NEAR(soil.axial_breakout.high, 270.60, 0.05);
  EXPECT_NEAR(soil.axial_residual.best, 70.155, 0.02) << "a third";
  EXPECT_GT(soil.hydrotest_breakout.best, 0);
  EXPECT_TRUE(std::isnan(soil.uplift.best));
}

TEST(RouteAnswer, of_clay_without_a_strength_ratio_has_the_undisturbed_strength_and_the_drained_one_at_most)
{
  RouteCase c = sample_route();
  Section& clay = c.section.front();
  clay.strength = {2000}, clay.strength_ratio.clear(), clay.interface_angle = {25 * degree};
  const Resistances soil = answer_of(c, no_run).front().soil;
  const Real w = soil.embedment.best;
  EXPECT_NEAR(soil.axial_breakout.best, formulas::axial_undrained(0.3239, w, 0.5 * (2000 + 1500 * w)).value, 1e-6);
  EXPECT_NEAR(soil.axial_residual.best, soil.axial_breakout.best / 3, 1e-9);
  EXPECT_NEAR(soil.axial_residual.high, formulas::axial_drained(0.3239, w, 25 * degree, 900).value, 1e-9);
  EXPECT_EQ(soil.axial_breakout.low, soil.axial_breakout.best);
}

TEST(RouteAnswer, of_sand_lies_where_the_laying_left_it_and_is_residual_between_the_seabed_and_its_trench)
{
  const RouteCase c = sample_route();
  const Resistances soil = answer_of(c, no_run)[1].soil;
  const Section& sand = c.section[1];
  const formulas::PipeInSand pipe{0.3239, soil.embedment.best, sand.unit_weight, 33 * degree, 28 * degree};
  EXPECT_NEAR(f114_drained_vertical(pipe).value, 1400, 1e-3) << "twice the weight of laying";
  EXPECT_NEAR(soil.lateral_breakout.best, f114_drained_lateral(pipe, 900).value, 1e-9);
  EXPECT_NEAR(soil.lateral_residual.low, 900 * std::tan(25 * degree), 1e-9) << "on the seabed, with the low interface";
  EXPECT_LT(soil.lateral_residual.best, soil.lateral_breakout.best);
  EXPECT_EQ(soil.axial_breakout.best, soil.axial_residual.best);
}

TEST(RouteAnswer, lay_factor_by_f114_is_that_of_the_resistance_where_the_pipe_comes_to_lie)
{
  RouteCase c = sample_route();
  c.pipe.lay_factor.reset();
  c.section.front().strength = {2000};
  const Real w = answer_of(c, no_run).front().soil.embedment.best;
  const formulas::PipeInClay clay{0.3239, w, (2000 + 1500 * w) / 3, 0.5, 500, 5000};
  const Real Q = f114_undrained_model_2(clay).value, EI = 3.78647722e7;
  EXPECT_NEAR(Q / 700, std::max<Real>(1, 0.6 + 0.4 * std::pow(Q * EI / (50e3 * 50e3 * w), 0.25)), 1e-4);
}

// P_0 = E A_s alpha dT + (1 - 2 nu) A_i dp - T with A_s = 0.015385 m2, A_i = 0.067012 m2: 3184.697 MN x 1.17e-5 x 80 + 0.4 x 0.067012 x 15 MPa - 50 kN = 3.33295 MN.
// Hobbs by a search over the length, 1 cm apart, with h = 772.37 and f = 150.33 N/m: 0.704553 MN with three lobes, before 0.706501 with four and 0.712166 with two.
TEST(RouteAnswer, screens_by_the_lowest_of_hobbs_modes_with_low_resistances)
{
  RouteCase anchored = sample_route();
  anchored.operation.ends = Ends::anchored;
  const Screening s = answer_of(anchored, no_run).front().screening;
  EXPECT_EQ(s.compression, s.constrained_force);
  EXPECT_NEAR(s.constrained_force, 3332948, 10);
  EXPECT_EQ(s.lobes, 3);
  EXPECT_NEAR(s.hobbs, 704553, 50);
  EXPECT_NEAR(s.lateral, 3332948. / 704553, 1e-3);
  EXPECT_TRUE(std::isnan(s.curve));
  EXPECT_LT(s.anchor_spacing.low, s.anchor_spacing.best);
  EXPECT_LT(s.anchor_spacing.best, s.anchor_spacing.high);
  // Twice the slip length of Hobbs: half of the buckle, and where (P_0 - P)/f is spent, so that it does not move beyond.
  const Real spent = (s.constrained_force - s.buckle.compression) / 70.1546;
  EXPECT_NEAR(s.anchor_spacing.best, 2 * (s.buckle.half_length + spent), 1e-3 * s.anchor_spacing.best);
  EXPECT_NEAR(s.feed_in, std::pow(s.constrained_force - s.buckle.compression, 2) / (3184696561. * 70.1546), 1e-4 * s.feed_in);
}

// From a free end at KP 0 the high axial resistance of clay, 270.60 N/m, holds 4000 x 270.60 = 1.08239 MN at KP 4. In sand it grows on by f = high of sand, and P_0 falls by
// 3184.697 MN x 1.17e-5 x 48 K/12 km = 149.04 N/m from 2.73677 MN: they meet after (2736773 - 1082386)/(f + 149.04) m. The landfall beyond holds all.
TEST(RouteAnswer, compression_builds_up_from_free_ends_by_axial_resistance)
{
  const std::vector<SectionAnswer> answers = answer_of(sample_route(), no_run);
  EXPECT_EQ(answers[0].compression.front().force, 0);
  EXPECT_NEAR(answers[0].screening.compression, 1082386, 30);
  const Real f = answers[1].soil.axial_breakout.high, after = (2736773 - 1082386) / (f + 149.044);
  ASSERT_EQ(answers[1].compression.size(), 3u);
  EXPECT_NEAR(answers[1].compression[1].kp, 4000 + after, 0.5);
  EXPECT_NEAR(answers[1].screening.compression, 1082386 + f * after, 50);
  EXPECT_NEAR(answers[1].compression[2].force, 1618945, 10) << "P_0 at KP 11.5";
  EXPECT_NEAR(answers[1].screening.constrained_force, 2736773, 10) << "64 K at KP 4";
}

TEST(RouteAnswer, screens_a_curve_by_its_radius)
{
  const std::vector<SectionAnswer> answers = answer_of(sample_route(), no_run);
  const Screening& s = answers[1].screening;
  EXPECT_NEAR(s.curve, answers[1].soil.lateral_breakout.low * 1500, 1e-6);
  EXPECT_NEAR(s.lateral, s.compression / std::min(s.curve, s.hobbs), 1e-12);
}

// Uplift at H = 0.96195 m: least F114 of loose sand, 8500 (0.8 D + D^2 (1/2 - pi/8)) + 0.29 x 8500 H^2 = 4579.2 N/m, on vertical planes 4624.1, largest F114 of dense
// sand 7174.8. P_0 = 1.61894 MN at 34 K (KP 11.5): (1.16 - 4.76 sqrt(EI 700/0.3)/P) P sqrt(0.3 x 700/EI) = 1090.6 N/m.
TEST(RouteAnswer, screens_a_buried_line_by_what_holds_it_on_its_prop)
{
  const SectionAnswer answer = answer_of(sample_route(), no_run)[2];
  EXPECT_NEAR(answer.soil.uplift.low, 4579.2, 0.1);
  EXPECT_NEAR(answer.soil.uplift.best, 4624.1, 0.1);
  EXPECT_NEAR(answer.soil.uplift.high, 7174.8, 0.1);
  EXPECT_NEAR(answer.screening.download, 1090.6, 0.1);
  EXPECT_NEAR(answer.screening.upheaval, 1090.64 / (900 + 4579.19), 1e-5);
  EXPECT_TRUE(std::isnan(answer.soil.lateral_breakout.best)) << "formulas of an exposed pipe";
  EXPECT_TRUE(std::isnan(answer.screening.lateral));
}

TEST(RouteAnswer, of_a_cold_line_has_no_buckle)
{
  RouteCase c = sample_route();
  c.operation.temperature = {0, 0}, c.operation.pressure = {0, 0};
  const std::vector<SectionAnswer> answers = answer_of(c, no_run);
  EXPECT_LT(answers[0].screening.lateral, 0) << "in tension";
  EXPECT_TRUE(std::isnan(answers[0].screening.anchor_spacing.best));
  EXPECT_EQ(answers[2].screening.download, 0);
}

TEST(RouteAnswer, takes_the_springs_of_a_run_from_the_folder_beside_the_file)
{
  RouteCase c = sample_route();
  c.folder = "routes";
  c.section.front().run = "../out/flow";
  std::filesystem::path asked;
  const auto from = [&](const std::filesystem::path& folder, const Pipe&) {
    asked = folder;
    Resistances found;
    found.lateral_breakout = found.lateral_residual = {500, 600, 700};
    found.axial_breakout = found.axial_residual = {100, 150, 200};
    return found;
  };
  const SectionAnswer answer = answer_of(c, from).front();
  EXPECT_EQ(asked, std::filesystem::path("routes") / "../out/flow");
  EXPECT_EQ(answer.soil.lateral_breakout.high, 700);
  EXPECT_GT(answer.screening.hobbs, 0);
}

}  // namespace
}  // namespace berm::route::this_file
