// SPDX-License-Identifier: BSD-3-Clause
// Columns of displacements, jumps, and records that are repeated.
#include "samples/sample_driver.hpp"
#include "settings/load_checks.hpp"
#include "settings/symmetry.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// Of a displacement of some decimetres: some units in the last place.
constexpr Real round_off = 1e-15;

/// 0 until 0.1003 s, then with 0.3 m/s to 0.06 m at 0.3003 s, back with -0.9 m/s to -0.03 m at 0.4003 s, where it stays; in part of the record's time.
Real zigzag(Real t, Real time_scale = 1)
{
  const Real s = t / time_scale;
  if (s < 0.1003) return 0;
  if (s < 0.3003) return 0.3 * (s - 0.1003);
  return s < 0.4003 ? 0.06 - 0.9 * (s - 0.3003) : -0.03;
}

settings::StageSettings stage_with(settings::StageKind kind, const std::vector<std::pair<const char*, Real>>& parts)
{
  settings::StageSettings stage = stage_of(kind, "table");
  stage.load_times = {0, 0.1003, 0.3003, 0.4003, 0.5};
  for (const auto& [key, part] : parts)
    for (const Real value : {0., 0., 0.06, -0.03, -0.03}) stage.loads.of(key).push_back(part * value);
  return stage;
}

/// A step of some duration, no two of them the same, so that none ends where a row of the table is.
void step(Driver& run, int n, Real shorter = 1)
{
  const Real duration = shorter * dt * (1 + 0.4 * std::sin(0.7 * n));
  drive_rigids(run.problem.model, run.problem.state, duration);
  move_body(run.problem.model.rigid_bodies[0], run.pipe, duration);
  run.problem.state.time += duration;
}

Real since_begin(const Driver& run)
{
  return run.problem.state.time - run.problem.state.stage.begin_time;
}

TEST(DisplacementColumns, of_a_push_are_where_the_body_is_at_the_end_of_every_step)
{
  Driver run({push(0.7), stage_with(settings::StageKind::push, {{"w_displacement", 1}})});
  for (int n = 0; n < 50; ++n) step(run, n);
  run.next_stage();
  const Vec<2> begin = run.pipe.displacement;
  EXPECT_LT(begin[1], -0.03) << "it has gone and goes when the stage begins";
  run.soil_pushes({20, 500});
  for (int n = 0; since_begin(run) < 0.6; ++n) {
    step(run, n);
    ASSERT_NEAR(begin[1] - run.pipe.displacement[1], zigzag(since_begin(run)), round_off) << since_begin(run);
    ASSERT_EQ(run.pipe.displacement[0], begin[0]);
  }
}

TEST(DisplacementColumns, of_a_drag_are_both_at_the_end_of_every_step)
{
  Driver run({drag(0.7), stage_with(settings::StageKind::drag, {{"u_displacement", 1}, {"w_displacement", -0.5}})});
  for (int n = 0; n < 50; ++n) step(run, n);
  run.next_stage();
  const Vec<2> begin = run.pipe.displacement;
  for (int n = 0; since_begin(run) < 0.6; ++n) {
    step(run, n);
    ASSERT_NEAR(run.pipe.displacement[0] - begin[0], zigzag(since_begin(run)), round_off) << since_begin(run);
    ASSERT_NEAR(run.pipe.displacement[1] - begin[1], 0.5 * zigzag(since_begin(run)), round_off) << since_begin(run);
  }
}

TEST(DisplacementColumns, of_a_drive_are_along_its_axes_and_about_it)
{
  Driver run({stage_with(settings::StageKind::drive, {{"x_displacement", 2}, {"y_displacement", 1}, {"rotation_angle", -10}})});
  for (int n = 0; since_begin(run) < 0.6; ++n) {
    step(run, n);
    const Real expected = zigzag(since_begin(run));
    ASSERT_NEAR(run.pipe.displacement[0], 2 * expected, round_off) << since_begin(run);
    ASSERT_NEAR(run.pipe.displacement[1], expected, round_off) << since_begin(run);
    ASSERT_NEAR(run.pipe.orientation.angle, -10 * expected, 10 * round_off) << since_begin(run);
  }
}

TEST(DisplacementColumns, drive_the_point_of_a_drive_to_the_second_order_of_the_angle_of_a_step)
{
  settings::StageSettings stage = stage_with(settings::StageKind::drive, {{"x_displacement", 2}, {"y_displacement", 1}});
  stage.drive.point = {1.1, 1.6};
  const Vec<2> arm(0.1, 0.3);
  for (const Real turn : {0., -10.}) {
    stage.loads.of("rotation_angle").clear();
    for (const Real value : {0., 0., 0.06, -0.03, -0.03}) stage.loads.of("rotation_angle").push_back(turn * value);
    Driver run({stage});
    for (int n = 0; since_begin(run) < 0.6; ++n) {
      step(run, n);
      const Vec<2> point = run.pipe.displacement + bodies::turn<2>(run.pipe.orientation.angle) * arm - arm;
      const Real angle = 0.9 * std::abs(turn) * 1.4 * dt;  // the most in a step
      const Real allowed = round_off + arm.norm() * angle * angle / 2;
      ASSERT_NEAR(point[0], 2 * zigzag(since_begin(run)), allowed) << since_begin(run);
      ASSERT_NEAR(point[1], zigzag(since_begin(run)), allowed) << since_begin(run);
    }
  }
}

TEST(DisplacementColumns, keep_their_travel_where_the_time_is_scaled)
{
  settings::StageSettings stage = stage_with(settings::StageKind::drag, {{"u_displacement", 1}});
  stage.time_scale = 0.25;
  Driver run({stage});
  for (int n = 0; since_begin(run) < 0.15; ++n) {
    step(run, n, 0.25);
    ASSERT_NEAR(run.pipe.displacement[0], zigzag(since_begin(run), 0.25), round_off) << since_begin(run);
  }
  EXPECT_NEAR(speed_of(stage), 0.9 / 0.25, 1e-12) << "where it is steepest";
}

TEST(DisplacementColumns, of_an_angle_in_space_turn_the_body_about_its_axis_by_it)
{
  settings::Case c = pipe_over_box({stage_with(settings::StageKind::drive, {{"z_displacement", 1}, {"rotation_y_angle", 20}})});
  c.geometry = settings::Geometry::space;
  mesh::BoxMesh box;
  box.size = {2, 2, 2};
  box.cells = {2, 2, 2};
  c.mesh = box;
  c.rigid[0].second.shape = bodies::BoxSettings{{0, 5, 0}, {1, 2, 3}, 0, {}};
  Problem<3> problem = build<3>(c, ".", ".");
  begin_stage(problem.model, problem.state);
  bodies::RigidState<3>& box_now = problem.state.rigid_bodies[0];
  while (problem.state.time < 0.5) {
    drive_rigids(problem.model, problem.state, 0.0007);
    move_body(problem.model.rigid_bodies[0], box_now, 0.0007);
    problem.state.time += 0.0007;
    const Real expected = zigzag(problem.state.time);
    ASSERT_NEAR(box_now.displacement[2], expected, round_off);
    const Vec<3> turned = rotation_of(box_now.orientation);
    ASSERT_NEAR(turned[1], 20 * expected, 1e-12) << "the sum of some hundred steps";
    ASSERT_NEAR(std::hypot(turned[0], turned[2]), 0, round_off);
  }
}

TEST(DisplacementColumns, are_not_of_a_part_of_the_whole_body)
{
  settings::Case c = pipe_over_box({stage_with(settings::StageKind::push, {{"w_displacement", 1}})});
  c.symmetry = {"z"};
  EXPECT_EQ(part_of_whole(c).stage[0].loads.of("w_displacement"), c.stage[0].loads.of("w_displacement"));
}

std::string fault_of(const settings::StageSettings& stage)
{
  const settings::Case c = pipe_over_box({stage});
  return fault_of_loads(c, stage);
}

TEST(DisplacementColumns, that_a_body_cannot_follow_are_refused)
{
  settings::StageSettings stage = stage_with(settings::StageKind::push, {{"w_displacement", 1}});
  EXPECT_EQ(fault_of(stage), "");
  settings::StageSettings late = stage;
  late.load_times[0] = 0.05;
  EXPECT_NE(fault_of(late).find(
                "loads.w_displacement: w is the displacement since the start of the stage: its first row must be 0 at the time 0, "
                "and is 0 m at 0.05 s"),
            std::string::npos)
      << fault_of(late);
  settings::StageSettings off = stage;
  off.loads.of("w_displacement")[0] = 0.01;
  EXPECT_NE(fault_of(off).find("and is 0.01 m at 0 s; take its first value from all"), std::string::npos) << fault_of(off);
  settings::StageSettings jump = stage;
  jump.load_times[2] = jump.load_times[1];
  EXPECT_NE(fault_of(jump).find("loads.w_displacement: w jumps from 0 to 0.06 m at 0.1003 s: a body cannot"), std::string::npos);
  jump.loads.of("w_displacement")[2] = 0;
  EXPECT_EQ(fault_of(jump), "") << "another column may jump there";
  settings::StageSettings ramped = stage;
  ramped.ramp = 0.1;
  EXPECT_EQ(fault_of(ramped).find("ramp: is not for displacements"), 0u) << fault_of(ramped);
  settings::StageSettings by_force = drag(0.1, 0.1);
  by_force.load_times = stage.load_times;
  by_force.loads.of("w_displacement") = stage.loads.of("w_displacement");
  EXPECT_EQ(fault_of(by_force), "") << "the ramp is that of the velocity along x";
  settings::StageSettings both = stage;
  both.loads.of("w").assign(5, 0);
  EXPECT_NE(fault_of(both).find("cannot be combined with w_displacement: a degree of freedom is driven in one way only"),
            std::string::npos);
  settings::Case elements = pipe_over_box({stage});
  elements.method = settings::Method::fem;
  EXPECT_NE(fault_of_loads(elements, stage).find("not of velocities or displacements"), std::string::npos);
}

TEST(Jumps, of_a_force_act_from_their_time_on)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drag, "blow");
  stage.load_times = {0, 0.1, 0.1, 0.2};
  stage.loads.of("H") = {10, 20, -5, -5};
  Driver run({stage});
  for (int n = 1; n <= 250; ++n) {
    const Vec<2> before = run.pipe.velocity;
    run.step();
    const Real t = run.problem.state.time, force = 2 * (run.pipe.velocity - before)[0] / dt;  // m a, and m = 2 kg/m
    ASSERT_NEAR(force, t < 0.1 ? 10 + 100 * t : -5, 1e-9) << n;
  }
}

TEST(Jumps, of_velocities_and_factors_are_the_first_value_before_their_time_and_the_second_from_it_on)
{
  settings::StageSettings stage = drag(0.2);
  stage.load_times = {0, 0, 1, 1, 2, 2};
  stage.load_factors = {5, 0, 2, -1, -1, 3};
  EXPECT_EQ(load_factor(stage, 0), 0);
  EXPECT_EQ(load_factor(stage, 0.5), 1);
  EXPECT_NEAR(load_factor(stage, std::nextafter(1., 0.)), 2, 1e-12);
  EXPECT_EQ(load_factor(stage, 1), -1);
  EXPECT_EQ(load_factor(stage, 1.999), -1);
  EXPECT_EQ(load_factor(stage, 2), 3);
  EXPECT_EQ(load_factor(stage, 9), 3);
  settings::StageSettings columns = stage_of(settings::StageKind::drag, "columns");
  columns.load_times = {0, 1, 1, 2};
  columns.loads.of("u") = {0.1, 0.1, -0.3, -0.3};
  EXPECT_EQ(load_of_column(columns, 2, 0.99), 0.1);
  EXPECT_EQ(load_of_column(columns, 2, 1), -0.3);
}

TEST(Jumps, of_three_values_are_refused_and_of_finite_elements_all)
{
  settings::StageSettings stage = drag(0.2);
  stage.load_times = {0, 1, 1, 1};
  stage.load_factors = {0, 1, 2, 3};
  EXPECT_EQ(fault_of(stage).find("load_times: the time 1 s occurs three times: twice is a jump"), 0u) << fault_of(stage);
  stage.load_times = {0, 1, 1, 0.5};
  EXPECT_EQ(fault_of(stage), "load_times: times must ascend");
  stage.load_times = {0, 1, 1, 2};
  EXPECT_EQ(fault_of(stage), "");
  stage.velocity.reset();
  stage.force = 100;
  settings::Case elements = pipe_over_box({stage});
  elements.method = settings::Method::fem;
  EXPECT_EQ(fault_of_loads(elements, stage).find("load_times: the same time twice is a jump, and the finite element method"), 0u);
}

TEST(Repeat, runs_a_record_again_where_its_last_run_ended)
{
  settings::StageSettings stage = drag(0.2);
  stage.load_times = {0, 0.25, 0.75, 1};
  stage.load_factors = {0, 1, -1, 0};
  const settings::StageSettings once = stage;
  stage.load_repeat = 3;
  repeat_load_history(stage);
  EXPECT_EQ(stage.load_repeat, 1);
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 0.25, 0.75, 1, 1.25, 1.75, 2, 2.25, 2.75, 3}))
      << "where two runs agree one row is enough";
  for (Real t = 0; t < 3; t += 0.0625) EXPECT_EQ(load_factor(stage, t), load_factor(once, t - std::floor(t))) << t;
  EXPECT_EQ(load_factor(stage, 9), 0) << "constant after the last run";
}

TEST(Repeat, jumps_where_the_record_does_not_end_as_it_begins)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drag, "saw");
  stage.load_times = {0.5, 2};
  stage.loads.of("H") = {1, 4};
  stage.loads.of("V") = {7, 7};
  stage.load_repeat = 2;
  repeat_load_history(stage);
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0.5, 2, 2, 2.5, 4}));
  EXPECT_EQ(stage.loads.of("H"), (std::vector<Real>{1, 4, 1, 1, 4})) << "before its first row a record has that row's values";
  EXPECT_EQ(stage.loads.of("V"), (std::vector<Real>{7, 7, 7, 7, 7}));
  settings::StageSettings square = stage_of(settings::StageKind::drag, "square");
  square.load_times = {0, 0, 1, 1, 2, 2};
  square.loads.of("H") = {0, 1, 1, -1, -1, 0};
  square.load_repeat = 2;
  repeat_load_history(square);
  EXPECT_EQ(square.load_times, (std::vector<Real>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4})) << "no time stands three times";
  EXPECT_EQ(square.loads.of("H"), (std::vector<Real>{0, 1, 1, -1, -1, 1, 1, -1, -1, 0}));
  EXPECT_EQ(fault_of(square), "");
}

TEST(Repeat, of_a_displacement_needs_that_it_ends_where_it_began)
{
  settings::StageSettings stage = stage_with(settings::StageKind::drag, {{"u_displacement", 1}});
  stage.load_repeat = 4;
  EXPECT_EQ(
      fault_of(stage).find("load_repeat: u_displacement ends at -0.03 m and begins again at 0, where the body cannot jump: add a row"), 0u)
      << fault_of(stage);
  stage.loads.of("u_displacement").back() = 0;
  EXPECT_EQ(fault_of(stage), "");
  stage.loads.of("u_displacement").back() = 1e-17;  // a sine of a spreadsheet
  EXPECT_EQ(fault_of(stage), "");
  const settings::StageSettings once = stage;
  repeat_load_history(stage);
  EXPECT_EQ(stage.load_times.size(), 17u);
  EXPECT_EQ(fault_of(stage), "");
  Driver run({stage});
  for (int n = 0; since_begin(run) < 2.2; ++n) {
    step(run, n);
    const Real t = since_begin(run), of_record = t < 2 ? std::fmod(t, 0.5) : 0.5;
    // Where the times of a run round, a steep row is off by its speed times that.
    ASSERT_NEAR(run.pipe.displacement[0], load_of_column(once, 4, of_record), 4 * round_off) << t;
  }
  stage.load_repeat = 1000000;
  EXPECT_EQ(fault_of(stage).find("load_repeat: makes 17000000 rows"), 0u) << fault_of(stage);
}

}  // namespace
}  // namespace berm::problem::this_file
