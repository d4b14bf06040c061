// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/path.hpp"

#include "samples/made_run.hpp"
#include "structures/driven/quantities.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

using settings::StageKind;

/// A history of rows as they come.
class Rows {
public:
  void add(const char* stage, Real u, Real w, Real H, Real V)
  {
    const Real row[] = {static_cast<Real>(history.rows()), u, w, H, V};
    for (int k = 0; k < 5; ++k) history.values[k].push_back(row[k]);
    history.stage.emplace_back(stage);
  }
  run_folder::History history{columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"}), std::vector<std::vector<Real>>(5), {}};
};

constexpr Real D = 0.02;
const BodyScale scale{.width = D, .unit_weight = 430e3};

Stage push_by_velocity(const char* name)
{
  return {.name = name, .kind = StageKind::push};
}
Stage push_by_force(const char* name, Real force)
{
  Stage stage{.name = name, .kind = StageKind::push};
  stage.force = force;
  return stage;
}
Stage drag_along(const char* name, Real direction)
{
  Stage stage{.name = name, .kind = StageKind::drag};
  stage.direction = direction;
  return stage;
}

/// Pushed to 0.2 D, where V = 1000 N/m; unloaded to 300 N/m, while it still creeps down; dragged by 1 D with H = 200 N/m, and back with H = -150.
Rows unloaded_and_swept()
{
  Rows rows;
  rows.add("rest", 0, 0, 0, 0);
  for (int k = 1; k <= 100; ++k) rows.add("push", 0, 0.002 * k * D, 0, 10. * k);
  for (int k = 1; k <= 10; ++k) rows.add("unload", 0, (0.2 + 1e-5 * k) * D, 0, 1000 - 70. * k);
  for (int k = 1; k <= 500; ++k) rows.add("out", 0.002 * k * D, 0.2 * D + 1e-6 * k, 200, 300);
  for (int k = 1; k <= 500; ++k) rows.add("back", D - 0.002 * k * D, 0.25 * D, -150, 300);
  return rows;
}
const Stages sweep_stages{push_by_velocity("push"), push_by_force("unload", 300), drag_along("out", 1), drag_along("back", -1)};

TEST(Path, a_push_by_a_force_below_V_unloads_and_is_no_part_of_the_way_down)
{
  const Path path = path_of(unloaded_and_swept().history, sweep_stages);
  EXPECT_EQ(path.push.rows.size(), 100u);
  EXPECT_EQ(path.push.V.back(), 1000);
  ASSERT_EQ(path.other_pushes.size(), 1u);
  EXPECT_EQ(path.other_pushes[0].stage, "unload");
  const Stages loading{push_by_velocity("push"), push_by_force("unload", 3000)};
  EXPECT_EQ(path_of(unloaded_and_swept().history, loading).push.rows.size(), 110u);
}

TEST(Path, a_push_upwards_or_after_a_drag_is_no_part_of_the_way_down)
{
  Stages lifted = sweep_stages;
  lifted[1] = push_by_velocity("unload");
  lifted[1].upwards = true;
  EXPECT_EQ(path_of(unloaded_and_swept().history, lifted).push.rows.size(), 100u);
  const Stages after{drag_along("out", 1), push_by_velocity("back")};
  const Path path = path_of(unloaded_and_swept().history, after);
  EXPECT_TRUE(path.push.rows.empty());
  ASSERT_EQ(path.other_pushes.size(), 1u);
  EXPECT_EQ(path.other_pushes[0].stage, "back");
}

TEST(Path, what_loads_less_than_the_push_after_an_unloading_is_no_way_down)
{
  Rows rows = unloaded_and_swept();
  for (std::string& stage : rows.history.stage)
    if (stage == "out" || stage == "back") stage = "flood";
  const Stages stages{push_by_velocity("push"), push_by_force("unload", 300), push_by_force("flood", 500)};
  const Path path = path_of(rows.history, stages);
  EXPECT_EQ(path.push.rows.size(), 100u);
  ASSERT_EQ(path.other_pushes.size(), 2u);
  EXPECT_EQ(path.other_pushes[1].stage, "flood");
}

TEST(Path, each_drag_counts_travel_and_resistance_along_its_own_direction)
{
  const Path path = path_of(unloaded_and_swept().history, sweep_stages);
  ASSERT_EQ(path.drags.size(), 2u);
  const DragPath& back = path.drags[1];
  EXPECT_EQ(back.rows.size(), 501u) << "it begins with the row before its first";
  EXPECT_EQ(back.travel.front(), 0);
  EXPECT_NEAR(back.travel.back(), D, 1e-12);
  EXPECT_EQ(back.H.back(), 150);
  EXPECT_NEAR(back.u_begin, D, 1e-12);
}

TEST(Results, belong_to_their_stage)
{
  const Results results = results_from(unloaded_and_swept().history, scale, sweep_stages);
  EXPECT_NEAR(results.push_end->V, 1000, 1e-6);
  ASSERT_EQ(results.other_pushes.size(), 1u);
  EXPECT_EQ(results.other_pushes[0].V, 300);
  ASSERT_EQ(results.drags.size(), 2u);
  const DragResults &out = results.drags[0], &back = results.drags[1];
  EXPECT_NEAR(out.end->H, 200, 1e-6);
  EXPECT_NEAR(back.end->H, 150, 1e-6);
  EXPECT_NEAR(back.end->u, D, 1e-12);
  EXPECT_NEAR(*out.V, 300, 1e-9);
  EXPECT_NEAR(*out.over_penetration, 1000. / 300, 1e-6);
  EXPECT_NEAR(*out.residual, 200, 1e-6);
  EXPECT_NEAR(*out.V_rms_error, 0, 1e-9);
  EXPECT_NEAR(*results.V_noise, 0, 1e-9) << "V that is unloaded is no noise of the push";
}

TEST(Results, of_a_long_drag_go_to_its_end)
{
  Rows rows;
  rows.add("rest", 0, 0.1 * D, 0, 300);
  for (int k = 1; k <= 3000; ++k) rows.add("out", 0.002 * k * D, 0.1 * D, 100. + k, 300);
  const Results results = results_from(rows.history, scale, {drag_along("out", 1)});
  const DragResults& drag = results.drag();
  ASSERT_EQ(drag.points.size(), 13u);
  EXPECT_NEAR(drag.points.back().u, 6 * D, 1e-12);
  EXPECT_NEAR(drag.points.back().H, 3100, 1e-6);
  EXPECT_NEAR(drag.end->H, 3100 - 150, 1) << "mean over the last 0.6 D";
}

TEST(Results, of_a_short_push_stay_within_what_was_measured)
{
  // V grows to 700 N/m in the first 0.005 D of a push of 0.01 D, and stays.
  Rows rows;
  rows.add("rest", 0, 0, 0, 0);
  for (int k = 1; k <= 100; ++k) rows.add("push", 0, 1e-4 * k * D, 0, std::min(700., 14. * k));
  const Results results = results_from(rows.history, scale, {push_by_velocity("push")});
  EXPECT_NEAR(results.push_end->V, 700, 1e-6);
}

TEST(Results, of_a_short_drag_tell_its_end_and_not_its_turn)
{
  // 0.1 D, over the first half of which H turns from -100 to 100 N/m.
  Rows rows;
  rows.add("rest", 0, 0.1 * D, 0, 300);
  for (int k = 1; k <= 100; ++k) rows.add("out", 0.001 * k * D, 0.1 * D, std::min(100., -100 + 4. * k), 300);
  EXPECT_NEAR(results_from(rows.history, scale, {drag_along("out", 1)}).drag().end->H, 100, 1e-6);
}

TEST(Results, have_no_error_of_V_that_is_not_held_nor_of_its_ramp)
{
  Stages fixed = sweep_stages;
  fixed[2].holds_V = false;
  EXPECT_FALSE(results_from(unloaded_and_swept().history, scale, fixed).drag().V_rms_error);

  // V goes from 1000 to 500 N/m within 100 rows (1 s each).
  Rows rows;
  rows.add("rest", 0, 0.1 * D, 0, 1000);
  for (int k = 1; k <= 500; ++k) rows.add("out", 0.002 * k * D, 0.1 * D, 100, k < 100 ? 1000 - 5. * k : 500);
  Stage ramped = drag_along("out", 1);
  ramped.held_force = 500;
  EXPECT_GT(*results_from(rows.history, scale, {ramped}).drag().V_rms_error, 0.1);
  ramped.V_ramp = 100;
  EXPECT_NEAR(*results_from(rows.history, scale, {ramped}).drag().V_rms_error, 0, 1e-12);
  EXPECT_NEAR(*results_from(rows.history, scale, {ramped}).drag().V, 500, 1e-9);
}

TEST(Stages, follow_the_case)
{
  MadeRun made;
  settings::Case c = made.settings();
  c.stage[1].velocity = -0.1;
  c.stage[1].vertical_force = 500;
  c.stage[1].ramp = 0.25;
  c.stage.push_back(MadeRun::stage_of("pause", StageKind::drag));
  c.stage.back().velocity = 0;
  c.stage.push_back(MadeRun::stage_of("slide", StageKind::drag));
  c.stage.back().vertical = settings::Vertical::fixed;
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Stages stages = stages_of(c, {nan, 800, nan, nan});
  ASSERT_EQ(stages.size(), 3u) << "a drag that stands still is none";
  EXPECT_EQ(stages[1].direction, -1);
  EXPECT_EQ(stages[1].held_force, 800);
  EXPECT_EQ(stages[1].V_ramp, 0.25);
  EXPECT_EQ(stages[2].name, "slide");
  EXPECT_FALSE(stages[2].holds_V || stages[2].held_force);
}

TEST(Stages, of_a_velocity_that_turns_round_are_several)
{
  settings::Case c = MadeRun{}.settings();
  c.stage[1].load_times = {0, 1, 3, 4};
  c.stage[1].load_factors = {0, 1, -1, 0};
  const Stages stages = stages_of(c);
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[1].name, "drag_1");
  EXPECT_EQ(stages[2].name, "drag_2");
  EXPECT_EQ(stages[1].direction, 1);
  EXPECT_EQ(stages[2].direction, -1);
  EXPECT_DOUBLE_EQ(stages[1].to, 2);
  Rows rows;
  rows.add("push", 0, 0, 0, 0);
  for (int k = 1; k <= 4; ++k) rows.add("drag", k < 3 ? 0.1 * k * D : (0.4 - 0.1 * k) * D, 0.1 * D, k < 3 ? 50 : -50, 300);
  const Path path = path_of(rows.history, stages);
  ASSERT_EQ(path.drags.size(), 2u);
  EXPECT_NEAR(path.drags[0].travel.back(), 0.2 * D, 1e-12);
  EXPECT_NEAR(path.drags[1].travel.back(), 0.2 * D, 1e-12);
  EXPECT_EQ(path.drags[1].H.back(), 50);
}

TEST(Stages, of_a_displacement_that_turns_round_are_several)
{
  settings::Case c = MadeRun{}.settings();
  c.stage[1].velocity.reset();
  c.stage[1].time_scale = 0.5;
  c.stage[1].load_times = {0, 1, 2, 3, 5, 6};
  c.stage[1].loads.of("u_displacement") = {0, 0, 0.2, 0.2, -0.2, 0};
  const Stages stages = stages_of(c);
  ASSERT_EQ(stages.size(), 4u);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(stages[k].direction, k == 2 ? -1 : 1) << k;
  EXPECT_EQ(stages[1].from, 0);
  EXPECT_EQ(stages[1].to, 1.5) << "until it goes back, after a rest";
  EXPECT_EQ(stages[2].to, 2.5);
  c.stage[0].velocity.reset();
  c.stage[0].load_times = {0, 1};
  c.stage[0].loads.of("w_displacement") = {0, -0.1};
  EXPECT_TRUE(stages_of(c)[0].upwards);
}

TEST(Stages, of_kind_drive_are_pushes_and_drags_too)
{
  settings::Case c = MadeRun{}.settings();
  settings::StageSettings drive = MadeRun::stage_of("drive", settings::StageKind::drive);
  drive.velocity.reset();
  drive.drive.y.hold = true;
  c.stage.push_back(drive);
  EXPECT_EQ(stages_of(c).size(), 2u) << "it drives nothing";
  c.stage.back().drive.x.velocity = -0.1;
  EXPECT_EQ(stages_of(c)[2].kind, StageKind::drag);
  EXPECT_EQ(stages_of(c)[2].direction, -1);
  EXPECT_TRUE(stages_of(c)[2].holds_V);
  c.stage.back().drive.y = {};
  c.stage.back().load_times = {0, 1};
  c.stage.back().loads.of("y_force") = {-300, -200};
  EXPECT_FALSE(stages_of(c)[2].holds_V);
  EXPECT_EQ(stages_of(c)[2].asked.loads.of("V"), (std::vector<Real>{300, 200})) << "downwards";
  EXPECT_EQ(stages_of(c)[2].asked.vertical, settings::Vertical::hold) << "w is not fixed";
  c.stage.back().drive.x.velocity.reset();
  c.stage.back().loads = {};
  c.stage.back().loads.of("x_displacement") = {0, -0.2};
  EXPECT_EQ(stages_of(c)[2].kind, StageKind::drag);
  EXPECT_EQ(stages_of(c)[2].direction, -1);
  c.stage.back().loads = {};
  c.stage.back().loads.of("y_displacement") = {0, -0.2};
  EXPECT_EQ(stages_of(c)[2].kind, StageKind::push);
  EXPECT_FALSE(stages_of(c)[2].upwards);
  c.stage.back().loads = {};
  c.stage.back().load_times = {};
  c.stage.back().drive.x.velocity.reset();
  c.stage.back().drive.y = {};
  c.stage.back().drive.y.velocity = 0.1;
  EXPECT_EQ(stages_of(c)[2].kind, StageKind::push);
  EXPECT_TRUE(stages_of(c)[2].upwards);
}

}  // namespace
}  // namespace berm::driven::this_file
