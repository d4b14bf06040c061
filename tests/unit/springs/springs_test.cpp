// SPDX-License-Identifier: BSD-3-Clause
#include "springs/springs.hpp"

#include "formulas/axial.hpp"
#include "formulas/rebound.hpp"
#include "material/clay.hpp"
#include "os/error.hpp"
#include "samples/lived_pipe.hpp"
#include "samples/made_run_in_water.hpp"
#include "springs/design.hpp"

#include <gtest/gtest.h>

namespace berm::springs::this_file {
namespace {

/// H of a finite element run, which has no noise: straight to its peak of 60 N/m at 0.05 D, straight down to 40 N/m at 0.15 D, level from there.
MadeRun run_with_peak()
{
  MadeRun run;
  run.method = settings::Method::fem;
  run.gravity_level = 1;
  run.held_V = 80;
  run.H = [](Real u) { return u < 0.001 ? 6e4 * u : u < 0.003 ? 60 - 1e4 * (u - 0.001) : 40; };
  return run;
}

TEST(Springs, of_a_drag_are_its_peak_its_residual_and_where_they_are)
{
  const Springs s = springs_of(run_with_peak().record());
  ASSERT_EQ(s.lateral.size(), 1u);
  const Lateral& l = s.lateral[0];
  EXPECT_EQ(l.stage, "drag");
  EXPECT_TRUE(l.breaks);
  constexpr Real row = 0.002 * 0.02;  // m of travel between rows
  EXPECT_NEAR(l.peak, 60, 1e-9);
  EXPECT_NEAR(l.u_peak, 0.001, row);
  for (std::size_t k = 0; k < mobilised_parts.size(); ++k) EXPECT_NEAR(l.mobilised[k], 0.001 * mobilised_parts[k], 1e-9);
  EXPECT_NEAR(l.stiffness(), 6e4, 1);
  EXPECT_NEAR(l.residual, 40, 1e-9);
  EXPECT_NEAR(l.u_residual, 0.0028, row) << "within 5 % of 40 N/m";
  EXPECT_NEAR(l.V, 80, 1e-9);
  EXPECT_NEAR(l.travel, 0.01, row);
  const Points spring = l.spring();
  ASSERT_EQ(spring.size(), 8u);
  EXPECT_EQ(spring[0].F, 0);
  EXPECT_NEAR(spring[2].F, 30, 1e-9);
  EXPECT_NEAR(spring[5].F, 60, 1e-9);
  EXPECT_EQ(spring[7].F, spring[6].F);
  for (std::size_t k = 1; k < spring.size(); ++k) EXPECT_GT(spring[k].x, spring[k - 1].x);
}

TEST(Springs, of_a_drag_without_a_peak_grow_to_its_end_and_have_no_residual)
{
  MadeRun run = run_with_peak();
  run.H = [](Real u) { return 1000 * std::sqrt(u); };
  const Lateral l = springs_of(run.record()).lateral.at(0);
  EXPECT_FALSE(l.breaks);
  EXPECT_NEAR(l.peak, 100, 1);
  EXPECT_TRUE(std::isnan(l.residual));
  // The mean of 1000 sqrt(u) over the last 0.1 D of 0.5 D.
  EXPECT_NEAR(l.end, 100 * 2. / 3 * (1 - std::pow(0.8, 1.5)) / 0.2, 0.3);
  EXPECT_NEAR(l.spring().back().F, l.peak, 1e-9) << "it does not fall";
}

TEST(Springs, of_a_drag_that_falls_to_its_end_do_not_stay_at_the_peak)
{
  MadeRun run = run_with_peak();
  run.H = [](Real u) { return u < 0.001 ? 6e4 * u : 60 - 4000 * (u - 0.001); };
  const Lateral l = springs_of(run.record()).lateral.at(0);
  EXPECT_TRUE(l.breaks);
  EXPECT_TRUE(std::isnan(l.residual));
  EXPECT_NEAR(l.spring().back().F, 60 - 4000 * 0.008, 3) << "the mean over the end, which is a tenth of D long";
}

TEST(Springs, of_a_drag_whose_largest_H_lies_behind_its_peak_have_a_point_there)
{
  MadeRun run = run_with_peak();
  // 60 N/m at 0.05 D, 40 N/m at 0.15 D, 90 N/m at 0.3 D, falling to the end.
  run.H = [](Real u) {
    return u < 0.001 ? 6e4 * u : u < 0.003 ? 60 - 1e4 * (u - 0.001) : u < 0.006 ? 40 + 5e4 / 3 * (u - 0.003) : 90 - 8000 * (u - 0.006);
  };
  const Lateral l = springs_of(run.record()).lateral.at(0);
  EXPECT_TRUE(l.breaks);
  EXPECT_NEAR(l.peak, 60, 1e-9);
  EXPECT_TRUE(std::isnan(l.residual));
  EXPECT_NEAR(l.largest, 90, 1e-9);
  EXPECT_NEAR(l.u_largest, 0.006, 1e-9);
  const Points spring = l.spring();
  ASSERT_EQ(spring.size(), 8u) << "the origin, four on the way to the peak, the peak, the largest H, the end";
  EXPECT_NEAR(spring[5].F, 60, 1e-9);
  EXPECT_NEAR(spring[6].x, 0.006, 1e-9);
  EXPECT_NEAR(spring[6].F, 90, 1e-9);
  EXPECT_LT(spring[7].F, 70);
  for (std::size_t k = 1; k < spring.size(); ++k) EXPECT_GT(spring[k].x, spring[k - 1].x);
}

TEST(Springs, ascend_whether_the_largest_H_lies_before_or_behind_the_residual)
{
  Lateral l;
  l.breaks = true;
  l.peak = 60, l.u_peak = 1, l.residual = 40, l.largest = 90, l.travel = 10;
  for (const auto& [u_residual, u_largest] : {std::pair(2, 5), std::pair(5, 2)}) {
    l.u_residual = u_residual, l.u_largest = u_largest;
    const Points spring = l.spring();
    ASSERT_EQ(spring.size(), 5u);
    EXPECT_EQ(spring[u_largest == 2 ? 2 : 3].F, 90);
    for (std::size_t k = 1; k < spring.size(); ++k) EXPECT_GT(spring[k].x, spring[k - 1].x);
  }
}

TEST(Springs, have_the_stiffness_of_the_first_known_part_of_the_peak_from_half_of_it_on)
{
  Lateral l;
  l.peak = 60, l.u_peak = 0.02;
  EXPECT_NEAR(l.stiffness(), 60 / 0.02, 1e-9);
  l.mobilised[2] = 0.01;
  EXPECT_NEAR(l.stiffness(), 45 / 0.01, 1e-9);
  l.mobilised[1] = 0.005;
  EXPECT_NEAR(l.stiffness(), 30 / 0.005, 1e-9);
  l.mobilised = {nan, nan, nan, nan};
  l.u_peak = 0;
  EXPECT_FALSE(is_stiffness(l.stiffness())) << "H begins with its peak";
}

TEST(Springs, of_a_centrifuge_are_those_of_its_prototype)
{
  MadeRun at_1 = run_with_peak(), at_50 = at_1;
  at_50.gravity_level = 50;
  const Springs model = springs_of(at_1.record()), prototype = springs_of(at_50.record());
  EXPECT_EQ(model.scale, 1);
  EXPECT_EQ(prototype.scale, 50);
  EXPECT_NEAR(prototype.diameter, 1, 1e-12);
  EXPECT_NEAR(prototype.lateral[0].peak, 50 * model.lateral[0].peak, 1e-9);
  EXPECT_NEAR(prototype.lateral[0].u_peak, 50 * model.lateral[0].u_peak, 1e-12);
  for (std::size_t k = 0; k < model.lateral[0].mobilised.size(); ++k)
    EXPECT_NEAR(prototype.lateral[0].mobilised[k], 50 * model.lateral[0].mobilised[k], 1e-12) << k;
  EXPECT_GT(model.lateral[0].mobilised[0], 0);
  for (const auto number : {&Lateral::u_residual, &Lateral::travel, &Lateral::residual, &Lateral::end, &Lateral::V})
    EXPECT_NEAR(prototype.lateral[0].*number, 50 * model.lateral[0].*number, 1e-9);
  EXPECT_NEAR(prototype.lateral[0].curve.back().x, 50 * model.lateral[0].curve.back().x, 1e-12);
  EXPECT_NEAR(prototype.vertical.preload, 50 * model.vertical.preload, 1e-9);
  EXPECT_NEAR(prototype.vertical.rebound, model.vertical.rebound, 1e-9) << "a stress";
  EXPECT_NEAR(prototype.vertical.curve.back().F, 50 * model.vertical.curve.back().F, 1e-9);
  EXPECT_NEAR(prototype.axial.drained, 50 * model.axial.drained, 1e-9);
  // 0.01 D of 20 mm, but 5 mm of 1 m.
  EXPECT_NEAR(prototype.axial.residual, 50 * model.axial.residual, 1e-9);
  EXPECT_NEAR(model.axial.u_breakout.best, 0.2e-3, 1e-12);
  EXPECT_NEAR(prototype.axial.u_breakout.best, 5e-3, 1e-12) << "the formula's millimetres are those of the prototype";
  EXPECT_NEAR(prototype.axial.u_breakout.low, 1.25e-3, 1e-12);
  EXPECT_NEAR(prototype.axial.u_breakout.high, 50e-3, 1e-12);
}

TEST(Springs, of_a_pipe_in_the_bed_from_the_start_have_the_stiffness_of_its_push_and_no_penetration)
{
  MadeRun run = run_with_peak();
  run.first_w = 0.008;
  run.pushed_to = 0.01;
  const Springs s = springs_of(run.record());
  EXPECT_TRUE(s.vertical.curve.empty());
  ASSERT_EQ(s.vertical.unloading.size(), 1u);
  EXPECT_NEAR(s.vertical.unloading[0].stiffness, 4e5, 1e-3);
  EXPECT_NEAR(s.embedment, 0.01, 1e-9);
}

TEST(Springs, along_the_axis_are_those_of_the_interface)
{
  const Springs sand = springs_of(run_with_peak().record());
  EXPECT_NEAR(sand.axial.drained, sand.axial.wedging * std::tan(70. / 3 * degree) * 80, 1e-9);
  EXPECT_TRUE(std::isnan(sand.axial.undrained)) << "no adhesion";
  MadeRun clay = run_with_peak();
  clay.law = MadeRun::clay_law();
  clay.contact.friction_angle = 0;
  clay.contact.adhesion_factor = 0.3;
  const Springs s = springs_of(clay.record());
  EXPECT_TRUE(std::isnan(s.axial.drained));
  const Real b = std::acos(1 - 2 * 0.1);
  EXPECT_NEAR(s.axial.undrained, 0.3 * 1000 * 0.02 * b, 1e-9);
  EXPECT_EQ(axial_displacement_source(), "DNVGL-RP-F114, table 4-2");
  EXPECT_EQ(s.axial.strength, "undisturbed clay");
  EXPECT_EQ(s.axial.sensitivity, 1);
  record::RunRecord sensitive = clay.record();
  material::Clay law;
  law.density = clay.law.density, law.undrained_strength = 1000, law.sensitivity = 3;
  sensitive.settings.material[0].second = law;
  EXPECT_NEAR(springs_of(sensitive).axial.undrained, s.axial.undrained, 1e-9) << "not remoulded";
  EXPECT_EQ(springs_of(sensitive).axial.sensitivity, 3);
  EXPECT_NEAR(springs_of(sensitive).axial.residual, s.axial.undrained / 3, 1e-9) << "remoulded";
  EXPECT_NEAR(s.axial.residual, s.axial.undrained, 1e-9);
  clay.contact.adhesion_factor = 0, clay.contact.adhesion = 300;
  EXPECT_EQ(springs_of(clay.record()).axial.strength, "given adhesion");
  clay.contact.adhesion = 0;
  clay.contact.adhesion_factor = 0;
  EXPECT_TRUE(std::isnan(springs_of(clay.record()).axial.u_breakout.best)) << "smooth: nothing is mobilised";
}

// The flowline of `berm new flowline` by hand: D = 0.4 m at w = 0.2386 D, s_u = 2 kPa + 1.5 kPa/m, alpha 0.5, sensitivity 3.
// b = acos(1 - 2 x 0.2386) = 1.02066, D b = 0.40826 m, s_u(invert) = 2000 + 1500 x 0.09544 = 2143.16 Pa: 0.5 x 2143.16 x 0.40826 = 437.49 N/m; over 3: 145.83 N/m.
TEST(Springs, along_the_axis_of_a_flowline_in_sensitive_clay_fall_from_breakout_to_a_third)
{
  MadeRun made = run_with_peak();
  made.D = 0.4, made.first_w = 0.0006 * 0.4, made.pushed_to = 0.2386 * 0.4, made.dragged = 0.1, made.left = 4;
  made.held_V = 1200;
  made.V = [](Real w) { return 3e4 * w; };
  made.H = [](Real u) { return 1e4 * u; };
  made.contact.friction_angle = 0;
  made.contact.adhesion_factor = 0.5;
  record::RunRecord run = made.record();
  material::Clay law;
  law.density = 600, law.undrained_strength = 2000, law.undrained_strength_gradient = 1500, law.sensitivity = 3;
  law.rigidity_index = 100, law.poisson_ratio = 0.45;
  run.settings.material[0].second = law;
  const Springs s = springs_of(run);
  EXPECT_NEAR(s.embedment, 0.09544, 1e-6);
  EXPECT_NEAR(s.axial.breakout(), 437.49, 0.01);
  EXPECT_NEAR(s.axial.residual, 145.83, 0.01);
  EXPECT_NEAR(s.axial.u_breakout.best, 4e-3, 1e-9);
  EXPECT_NEAR(s.axial.u_residual.best, 24e-3, 1e-9);
  EXPECT_EQ(s.axial.cyclic().low, s.axial.residual);
  // G = 100 x 2143.2 Pa at the invert.
  EXPECT_NEAR(s.vertical.rebound, 0.88 * 214316 / 0.55, 1) << "stiffness of the soil at the invert";
}

// V = 300 N/m in operation at w = 0.29 D, alpha 0.4, U = 0.5; a ratio of 4, which is no clay's, as the strength of this small pipe is large beside its V.
TEST(Springs, along_the_axis_of_consolidated_clay_grow_with_V_from_the_remoulded_strength)
{
  constexpr Real D = 0.02;
  const Springs plain = springs_of(lived_pipe());
  const Springs s = springs_of(lived_pipe(), {.clay = {.strength_ratio = 4, .consolidation = 0.5, .interface_angle = 30 * degree}});
  const Real zeta = formulas::wedging_factor(D, 0.29 * D).value;
  EXPECT_NEAR(s.axial.undrained, 0.4 * 4 * zeta * 0.5 * 300, 1e-6);
  ASSERT_EQ(s.axial.set_up.size(), 1u);
  EXPECT_EQ(s.axial.set_up[0].degree, 0.5);
  EXPECT_NEAR(s.axial.set_up[0].before, plain.axial.undrained, 1e-9) << "sensitivity 1";
  EXPECT_NEAR(s.axial.cyclic().high, std::max(s.axial.undrained, zeta * std::tan(30 * degree) * 300), 1e-6) << "drained";
  EXPECT_EQ(springs_of(lived_pipe(), {.clay = {.strength_ratio = 0.01}}).axial.undrained, plain.axial.undrained)
      << "no less than remoulded";
  EXPECT_NE(s.axial.undrained_source.find("DNV-RP-F114"), std::string::npos);
}

TEST(Springs, along_the_axis_are_none_of_a_pipe_that_is_lifted)
{
  MadeRun lifted = run_with_peak();
  lifted.dragged = 0;
  lifted.first_w = 0.008;
  lifted.pushed_to = 0.01;
  record::RunRecord run = lifted.record();
  run.settings.stage.push_back(MadeRun::stage_of("uplift", settings::StageKind::push));
  run.settings.stage.back().velocity = -0.1;
  run.settings.stage.back().role = settings::StageRole::operation;  // without a role it would be no operation
  for (int k = 1; k <= 50; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), 0, 0.01 - k * 1e-5, 0, -100. + k};
    for (int c = 0; c < 5; ++c) run.history.values[c].push_back(row[c]);
    run.history.stage.emplace_back("uplift");
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const Springs s = springs_of(run);
  EXPECT_EQ(s.state, "operation");
  EXPECT_LT(s.V, 0);
  for (const Real number : {s.axial.drained, s.axial.undrained, s.axial.residual, s.axial.u_breakout.best}) EXPECT_TRUE(std::isnan(number));
  ASSERT_EQ(s.missing.size(), 4u) << "sideways, downwards, along the axis, what there is instead";
  EXPECT_NE(s.missing[2].find("does not press the pipe onto the bed"), std::string::npos) << s.missing[2];
  EXPECT_EQ(s.missing[3], "resistance to uplift is uplift.R_max in summary.json");
}

TEST(Springs, along_the_axis_are_computed_where_water_was)
{
  const Springs s = springs_of(MadeRunInWater{}.record_with_normal_force());
  EXPECT_NEAR(s.axial.wedging, 1.1, 1e-9);
  EXPECT_NEAR(s.axial.drained, 50 * 550 * std::tan(70. / 3 * degree), 1e-6) << "of the prototype, at 50 g";
  EXPECT_NEAR(s.axial.settled, s.V * formulas::wedging_factor(1, 0.1).value * std::tan(70. / 3 * degree), 1e-6)
      << "once it has consolidated";
  ASSERT_EQ(s.axial.set_up.size(), 1u);
  EXPECT_EQ(s.axial.set_up[0].stage, "rest");
  EXPECT_NEAR(s.axial.set_up[0].degree, 0.75, 1e-12);
  EXPECT_NEAR(s.axial.set_up[0].before, 50 * 100 * std::tan(70. / 3 * degree), 1e-6);
  EXPECT_NEAR(s.axial.set_up[0].after, s.axial.drained, 1e-9);
  const Range band = s.axial.cyclic();
  EXPECT_EQ(band.low, s.axial.drained);
  EXPECT_EQ(band.high, std::max(s.axial.drained, s.axial.settled));
  for (const std::string& source : {s.axial.wedging_source, s.axial.drained_source})
    EXPECT_NE(source.find("computed effective normal force"), std::string::npos) << source;
}

TEST(Springs, are_refused_of_a_finished_run_whose_history_has_lost_its_drag)
{
  record::RunRecord record = run_with_peak().record();
  for (std::string& stage : record.history.stage)
    if (stage == "drag") stage = "push";
  EXPECT_THROW(springs_of(record), RunError);
  record.end = record::RunEnd::unfinished;
  EXPECT_NO_THROW(springs_of(record));
}

TEST(Springs, are_those_of_the_pipe_in_operation)
{
  constexpr Real D = 0.02;
  const Springs s = springs_of(lived_pipe());
  EXPECT_EQ(s.state, "operation");
  EXPECT_EQ(s.state_origin, "end of stage unload, before sweep_1");
  EXPECT_NEAR(s.embedment, 0.29 * D, 1e-9);
  EXPECT_NEAR(s.V, 300, 1e-9);
  ASSERT_EQ(s.lateral.size(), 2u) << "no drag of the laying";
  EXPECT_EQ(s.lateral[0].stage, "sweep_1");
  EXPECT_EQ(s.lateral[0].state, "operation");
  EXPECT_NEAR(s.lateral[1].residual, 80, 1e-6);
  EXPECT_NEAR(s.lateral[1].berm, 160, 1e-6);
  // Adhesion of 0.4 times 1 kPa over the contact of 0.29 D.
  EXPECT_NEAR(s.axial.undrained, 0.4 * 1000 * D * std::acos(1 - 2 * 0.29), 1e-6);
  EXPECT_NEAR(s.vertical.curve.back().x, 0.1 * D, 1e-9) << "as deep as it was pushed";
  EXPECT_NEAR(s.vertical.preload, 800, 1e-9);
  ASSERT_EQ(s.vertical.unloading.size(), 1u);
  EXPECT_NEAR(s.vertical.unloading[0].stiffness, 500 / (0.01 * D), 1);
}

TEST(Springs, are_none_of_a_bed_that_stages_dug_after_it_was_found)
{
  constexpr Real D = 0.02;
  record::RunRecord run = lived_pipe();
  bodies::ExcavationSettings trench;
  trench.name = "trench";
  trench.stage = "unload";
  trench.area.x = {D, 3 * D, 3 * D, D};
  trench.area.y = {-D, -D, 0, 0};
  run.settings.body.front().second.excavation.push_back(trench);
  const Springs s = springs_of(run, {.travels = {"lay_1", "sweep_1"}});
  EXPECT_EQ(s.state, "operation");
  EXPECT_TRUE(s.vertical.curve.empty()) << "the bed of touchdown";
  ASSERT_EQ(s.lateral.size(), 1u);
  EXPECT_EQ(s.lateral[0].stage, "sweep_1") << "after the excavation";
  EXPECT_TRUE(std::isnan(s.axial.undrained)) << "its strength is that of undisturbed soil";
  EXPECT_EQ(s.vertical.unloading.size(), 1u);
  ASSERT_EQ(s.missing.size(), 3u);
  for (const auto& [line, words] : {std::pair(0, "lay_1 has no lateral spring in state operation"),
                                    {1, "there is no vertical spring: the push was into soil that no longer exists in state operation"},
                                    {2, "there is no axial spring: the strength of the soil at the pipe is not known"}}) {
    EXPECT_EQ(s.missing[line].find(words), 0u) << s.missing[line];
    EXPECT_NE(s.missing[line].find("excavation trench, in stage \"unload\""), std::string::npos) << s.missing[line];
  }
  EXPECT_FALSE(springs_of(run, {.state = "touchdown"}).vertical.curve.empty()) << "which is before it";
}

TEST(Springs, of_a_sweep_that_only_meets_a_berm_are_none)
{
  record::RunRecord run = lived_pipe();
  constexpr Real D = 0.02;
  for (Index row = 0; row < run.history.rows(); ++row)
    if (run.history.stage[row] == "sweep_2") run.history.values[3][row] = -40 * (2 * D - run.history["u_m"][row]) / D;
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const Springs s = springs_of(run);
  const Lateral& l = s.lateral.at(1);
  EXPECT_TRUE(l.only_berm());
  EXPECT_TRUE(std::isnan(l.residual));
  EXPECT_NEAR(l.berm, 76, 0.5) << "the mean over the last 0.2 D of 40 N/m per D";
  EXPECT_TRUE(l.spring().empty());
  EXPECT_FALSE(l.curve.empty());
  ASSERT_FALSE(s.missing.empty());
  EXPECT_NE(s.missing[0].find("sweep_2 has no lateral spring: its H increases to 7"), std::string::npos) << s.missing[0];
}

TEST(Springs, before_a_berm_are_those_of_the_residual)
{
  const Lateral l = springs_of(lived_pipe()).lateral.at(1);
  EXPECT_FALSE(l.breaks);
  EXPECT_NEAR(l.peak, 80, 1e-6) << "not the 160 N/m against the berm";
  EXPECT_NEAR(l.u_peak, 0.2 * 0.02, 0.02 * 0.02);
  EXPECT_NEAR(l.spring().back().F, 80, 1e-6);
}

TEST(Springs, are_those_of_the_state_and_the_travels_that_are_asked_for)
{
  const Springs laid = springs_of(lived_pipe(), {.state = "laid", .travels = {"sweep_2"}});
  EXPECT_EQ(laid.state, "laid");
  EXPECT_NEAR(laid.V, 800, 1e-9);
  ASSERT_EQ(laid.lateral.size(), 1u);
  EXPECT_EQ(laid.lateral[0].stage, "sweep_2");
  EXPECT_TRUE(springs_of(lived_pipe(), {.state = "laid"}).lateral.empty()) << "its drags are those of operation";
  EXPECT_EQ(springs_of(lived_pipe(), {.state = "laid", .whole_life = true}).lateral.size(), 2u) << "but for those that lay it";
  EXPECT_EQ(springs_of(lived_pipe(), {.state = "after_sweep_1"}).lateral.at(0).stage, "sweep_2");
  EXPECT_THROW(springs_of(lived_pipe(), {.state = "lied"}), InputError);
  EXPECT_THROW(springs_of(lived_pipe(), {.travels = {"sweep_9"}}), InputError);
  record::RunRecord by_force = lived_pipe();
  by_force.settings.stage.back().velocity.reset();
  by_force.settings.stage.back().force = -100;
  EXPECT_THROW(springs_of(by_force, {.travels = {"sweep_2"}}), InputError);
}

TEST(Springs, say_which_drags_have_none_as_a_force_drives_them)
{
  MadeRun made = run_with_peak();
  record::RunRecord run = made.record();
  run.settings.stage.back().velocity.reset();
  run.settings.stage.back().force = 100;
  const Springs s = springs_of(run);
  EXPECT_TRUE(s.lateral.empty());
  ASSERT_EQ(s.missing.size(), 1u);
  EXPECT_EQ(s.missing[0], "\"drag\" is driven by a force: it gives displacements, no resistance");
  EXPECT_TRUE(springs_of(made.record()).missing.empty());
}

TEST(Springs, of_a_state_have_no_stiffness_of_pushes_behind_the_next_state)
{
  EXPECT_TRUE(springs_of(lived_pipe(), {.state = "touchdown"}).vertical.unloading.empty()) << "it is unloaded after it is laid";
  EXPECT_EQ(springs_of(lived_pipe(), {.state = "laid"}).vertical.unloading.size(), 1u) << "the push that leads to the next state";
}

TEST(Springs, have_no_stiffness_where_the_pipe_sinks_while_it_is_unloaded)
{
  record::RunRecord run = lived_pipe();
  std::vector<Real>& w = run.history.values[2];
  for (Index k = 0; k < run.history.rows(); ++k)
    if (run.history.stage[k] == "unload") w[k] = 0.6 * 0.02 - w[k];
  const Springs s = springs_of(run);
  EXPECT_LT(s.vertical.unloading.at(0).stiffness, 0);
  const std::vector<std::string> refused = refused_stiffnesses(s);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_NE(refused[0].find("V fell from 800 to 300 N/m while the pipe sank"), std::string::npos) << refused[0];
}

TEST(Springs, are_refused_of_a_run_without_a_pipe)
{
  MadeRun run = run_with_peak();
  record::RunRecord record = run.record();
  record.settings.rigid.clear();
  record.settings.contact.clear();
  record.settings.stage.clear();
  EXPECT_THROW(springs_of(record), RunError);
}

}  // namespace
}  // namespace berm::springs::this_file
