// SPDX-License-Identifier: BSD-3-Clause
#include "samples/sample_driver.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

TEST(Push, ramps_the_velocity_downwards_in_equal_parts)
{
  Driver run({push(0.5, 0.1)});
  for (int n = 1; n <= 150; ++n) {
    run.step();
    EXPECT_NEAR(run.pipe.velocity[1], n < 100 ? -0.5 * n / 100 : -0.5, 1e-12);
    EXPECT_EQ(run.pipe.velocity[0], 0);
  }
}

TEST(Push, without_a_ramp_moves_at_once)
{
  Driver run({push(0.5)});
  run.step();
  EXPECT_EQ(run.pipe.velocity, Vec<2>(0, -0.5));
}

TEST(Push, by_force_begins_with_the_force_that_balances_the_soil)
{
  settings::StageSettings by_force = stage_of(settings::StageKind::push, "force");
  by_force.force = 300;
  by_force.ramp = 0.1;
  Driver run({push(0.5), by_force});
  run.step();
  run.soil_pushes({0, 100});
  run.next_stage();
  for (int n = 1; n <= 200; ++n) {
    const Real before = run.pipe.velocity[1];
    run.step();
    // m a = reaction - drive, and the drive goes from 100 N/m to 300 N/m.
    const Real driven_by = n < 100 ? 100 + 2 * n : 300;
    EXPECT_NEAR((run.pipe.velocity[1] - before) / dt, (100 - driven_by) / 2, 1e-8) << n;
  }
}

TEST(Drag, begins_without_a_jump_of_the_velocity)
{
  Driver run({push(0.5), drag(0.2, 0.1)});
  run.step();
  run.soil_pushes({3, 70});
  run.next_stage();
  Vec<2> before = run.pipe.velocity;
  for (int n = 1; n <= 150; ++n) {
    run.step();
    EXPECT_LE((run.pipe.velocity - before).norm(), 0.2 / 100 + 1e-12);
    before = run.pipe.velocity;
  }
  EXPECT_NEAR(run.pipe.velocity[0], 0.2, 1e-15);
}

TEST(Drag, holds_the_vertical_force_of_the_moment_when_it_begins)
{
  Driver run({push(0), drag(0.2, 0.1)});
  run.step();
  run.soil_pushes({0, 70});
  run.next_stage();
  EXPECT_TRUE(run.problem.state.stage.drive[1].by_force);
  for (int n = 0; n < 150; ++n) {
    run.step();
    EXPECT_EQ(run.pipe.velocity[1], 0);
  }
  // 70 N/m stay, whatever the soil does.
  run.soil_pushes({0, 80});
  run.step();
  EXPECT_NEAR(run.pipe.velocity[1], dt * (80 - 70) / 2, 1e-15);
  run.soil_pushes({0, 60});
  run.step();
  EXPECT_NEAR(run.pipe.velocity[1], 0, 1e-15);
}

TEST(Drag, holds_the_force_that_drove_the_body_before)
{
  settings::StageSettings first = drag(0.2);
  first.vertical_force = 50;
  Driver run({first, drag(-0.2)});
  run.step();
  run.soil_pushes({0, 47});
  run.next_stage();
  EXPECT_TRUE(run.problem.state.stage.drive[1].by_force);
  EXPECT_EQ(run.problem.state.stage.drive[1].to, -50) << "and not the soil's reaction of that moment";
  EXPECT_EQ(run.problem.state.stage.drive[1].from, -50);
}

TEST(Drag, holds_the_end_of_the_load_history_that_pushed_the_body)
{
  settings::StageSettings falling = push(0);
  falling.velocity.reset();
  falling.force = 100;
  falling.load_times = {0, 10 * dt};
  falling.load_factors = {1, 0.5};
  Driver run({falling, drag(0.2)});
  run.soil_pushes({0, 40});
  for (int n = 0; n < 20; ++n) run.step();
  run.next_stage();
  EXPECT_NEAR(run.problem.state.stage.drive[1].to, -50, 1e-12);
}

TEST(Drag, follows_its_load_history_along_x_alone)
{
  settings::StageSettings storm = drag(0.2);
  storm.vertical_force = 50;
  storm.load_times = {0, 10 * dt};
  storm.load_factors = {0, 1};
  Driver run({storm});
  for (int n = 1; n <= 20; ++n) {
    run.soil_pushes({0, 50});
    run.step();
    EXPECT_NEAR(run.pipe.velocity[0], 0.2 * std::min(n, 10) / 10, 1e-12);
    EXPECT_EQ(run.pipe.velocity[1], 0) << "the force that is held does not follow it";
  }
}

TEST(Drag, goes_to_another_vertical_force_over_the_ramp)
{
  settings::StageSettings lighter = drag(0.2, 0.1);
  lighter.vertical_force = 20;
  Driver run({push(0), lighter});
  run.step();
  run.soil_pushes({0, 70});
  run.next_stage();
  for (int n = 1; n <= 120; ++n) {
    const Real before = run.pipe.velocity[1];
    run.step();
    EXPECT_NEAR((run.pipe.velocity[1] - before) / dt, (70 - (n < 100 ? 70 - 0.5 * n : 20)) / 2, 1e-8);
  }
}

TEST(Drag, with_the_vertical_fixed_stops_the_vertical_motion_over_the_ramp)
{
  settings::StageSettings level = drag(0.2, 0.1);
  level.vertical = settings::Vertical::fixed;
  Driver run({push(0.5), level});
  run.step();
  run.soil_pushes({0, 70});
  run.next_stage();
  for (int n = 1; n <= 120; ++n) {
    run.step();
    EXPECT_NEAR(run.pipe.velocity[1], n < 100 ? -0.5 * (1 - n / 100.) : 0, 1e-12);
  }
}

TEST(Drag, with_a_vertical_velocity_reaches_it_over_the_ramp_whatever_the_soil_does)
{
  settings::StageSettings slanted = drag(0.2, 0.1);
  slanted.vertical_velocity = 0.05;
  Driver run({push(0.5), slanted});
  run.step();
  run.soil_pushes({0, 70});
  run.next_stage();
  for (int n = 1; n <= 120; ++n) {
    run.step();
    EXPECT_NEAR(run.pipe.velocity[1], n < 100 ? -0.5 + 0.45 * n / 100 : -0.05, 1e-12);
  }
}

TEST(Drag, by_force_moves_the_body_by_its_mass_and_what_the_soil_leaves)
{
  settings::StageSettings by_force = stage_of(settings::StageKind::drag, "drag");
  by_force.force = 50;
  Driver run({by_force});
  run.soil_pushes({-30, 0});
  run.step();
  EXPECT_NEAR(run.pipe.velocity[0], dt * (50 - 30) / 2, 1e-15);
}

TEST(Drag, along_minus_x_meets_a_positive_resistance)
{
  settings::StageSettings back = drag(-0.2);
  back.until = {};
  back.until.force = 40;
  Driver run({back});
  EXPECT_EQ(drag_direction(run.problem.model, run.problem.state), -1);
  run.step();
  EXPECT_EQ(run.pipe.velocity[0], -0.2);
  run.soil_pushes({39, 0});  // the soil pushes along +x, against the drag
  EXPECT_FALSE(run.ended());
  run.soil_pushes({40, 0});
  EXPECT_TRUE(run.ended());

  settings::StageSettings pulled = stage_of(settings::StageKind::drag, "pulled");
  pulled.force = -5;
  EXPECT_EQ(drag_direction(Driver({pulled}).problem.model, Driver({pulled}).problem.state), -1);
  EXPECT_EQ(drag_direction(Driver({drag(0.2)}).problem.model, Driver({drag(0.2)}).problem.state), 1);
  EXPECT_EQ(drag_direction(Driver({push(-0.2)}).problem.model, Driver({push(-0.2)}).problem.state), 1);
}

TEST(Stage, ends_after_its_time)
{
  settings::StageSettings stage = push(0.5);
  stage.until.time = 0.1;
  Driver run({stage, stage});
  for (const int begun_at : {0, 100}) {  // the second counts from its own beginning
    for (int n = 1; n <= 100; ++n) {
      run.step();
      EXPECT_EQ(run.ended(), n == 100) << begun_at;
    }
    if (begun_at == 0) run.next_stage();
  }
}

TEST(Stage, ends_after_its_horizontal_travel_in_either_direction)
{
  for (const Real velocity : {0.5, -0.5}) {
    settings::StageSettings stage = drag(velocity);
    stage.until = {};
    stage.until.displacement = 0.02;
    Driver run({drag(0.1), stage});
    run.step();
    run.next_stage();
    int steps = 0;
    while (!run.ended() && steps < 1000) run.step(), ++steps;
    EXPECT_NEAR(steps, 40, 1);
  }
}

TEST(Stage, ends_at_its_embedment_below_the_surface)
{
  settings::StageSettings stage = push(0.5);
  stage.until = {};
  stage.until.embedment = 0.02;
  Driver run({stage});
  EXPECT_NEAR(run.w(), -0.1, 1e-15);  // the invert is 0.1 m above the surface
  int steps = 0;
  while (!run.ended() && steps < 1000) run.step(), ++steps;
  EXPECT_NEAR(steps, 240, 1);
  EXPECT_NEAR(run.w(), 0.02, 0.5 * dt);
}

TEST(Stage, ends_at_its_force)
{
  settings::StageSettings down = push(0.5), along = drag(0.5);
  down.until = along.until = {};
  down.until.force = along.until.force = 25;
  Driver pushed({down}), dragged({along});
  pushed.soil_pushes({-100, 24.9});
  dragged.soil_pushes({-24.9, 100});
  EXPECT_FALSE(pushed.ended());
  EXPECT_FALSE(dragged.ended());
  pushed.soil_pushes({0, 25});
  dragged.soil_pushes({-25, 0});
  EXPECT_TRUE(pushed.ended());
  EXPECT_TRUE(dragged.ended());
}

TEST(Stage, moves_no_rigid_body_where_it_drives_none)
{
  for (const settings::StageKind kind : {settings::StageKind::free, settings::StageKind::geostatic}) {
    Driver run({push(0.5), stage_of(kind)});
    run.step();
    run.next_stage();
    run.soil_pushes({5, 70});
    run.step();
    EXPECT_EQ(run.pipe.velocity, Vec<2>(0, 0));
    EXPECT_FALSE(run.ended());
  }
}

settings::Case free_pipe(std::vector<settings::StageSettings> stages)
{
  settings::Case c = pipe_over_box(std::move(stages));
  c.gravity = {3, -10};
  c.rigid[0].second.motion = bodies::Motion::free;
  return c;
}

TEST(FreeBody, moves_by_its_weight_and_the_force_of_the_soil)
{
  auto problem = build<2>(free_pipe({stage_of(settings::StageKind::free)}), ".", ".");
  bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
  pipe.velocity = {1, 2};
  pipe.reaction = {8, 12};  // 4 and 6 m/s2 of its 2 kg/m
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_NEAR((pipe.velocity - Vec<2>(1 + 7 * dt, 2 - 4 * dt)).norm(), 0, 1e-15);
  EXPECT_EQ(pipe.angular_velocity, 0);
}

TEST(FreeBody, rests_in_a_geostatic_stage_and_follows_the_drive_of_a_stage)
{
  auto problem = build<2>(free_pipe({stage_of(settings::StageKind::geostatic), drag(0.2)}), ".", ".");
  bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
  pipe.reaction = {8, 12};
  pipe.recent = bodies::RecentReaction<2>::steady(pipe.reaction, 0);
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_EQ(pipe.velocity, Vec<2>(0, 0));
  ++problem.state.stage.index;
  begin_stage(problem.model, problem.state);
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_EQ(pipe.velocity, Vec<2>(0.2, 0));  // the 12 N/m that the soil carries are held
}

TEST(FreeBody, gets_the_work_of_its_weight_from_outside_and_that_of_the_soil_from_within)
{
  auto problem = build<2>(free_pipe({stage_of(settings::StageKind::free)}), ".", ".");
  bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
  Real of_weight = 0;
  for (int n = 0; n < 100; ++n) {
    pipe.reaction = {5. + n, 40. - n};
    problem.state.ledger.totals.external -= dt * pipe.reaction.dot(pipe.velocity);  // what the contact counts as work on the soil
    const Vec<2> before = pipe.velocity;
    drive_rigids(problem.model, problem.state, dt);
    of_weight += dt * 2 * Vec<2>(3, -10).dot(before + pipe.velocity) / 2;
    EXPECT_NEAR(problem.state.ledger.totals.external, of_weight, 1e-13);
  }
}

TEST(FreeBody, gets_its_kinetic_energy_from_a_drive_and_loses_it_where_it_is_stopped)
{
  auto problem = build<2>(free_pipe({drag(0.2, 0.1), stage_of(settings::StageKind::geostatic)}), ".", ".");
  bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
  for (int n = 0; n < 150; ++n) {
    drive_rigids(problem.model, problem.state, dt);
    problem.state.time += dt;
  }
  EXPECT_NEAR(problem.state.ledger.totals.external, 0.5 * 2 * 0.2 * 0.2, 1e-14);
  EXPECT_NEAR(kinetic_energy(problem.model.rigid_bodies[0], pipe), 0.5 * 2 * 0.2 * 0.2, 1e-14);
  ++problem.state.stage.index;
  begin_stage(problem.model, problem.state);
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_NEAR(problem.state.ledger.totals.external, 0, 1e-14);
}

settings::StageSettings drive()
{
  return stage_of(settings::StageKind::drive, "drive");
}

TEST(Drive, of_each_freedom_does_what_it_says)
{
  settings::StageSettings stage = drive();
  stage.drive.x.velocity = -0.3;
  stage.drive.y.force = -50;
  stage.drive.rotation.velocity = 2;
  Driver run({stage});
  run.step();
  EXPECT_NEAR(run.pipe.velocity[0], -0.3, 1e-15);
  EXPECT_NEAR(run.pipe.velocity[1], -50 * dt / 2, 1e-15);  // of 2 kg/m
  EXPECT_NEAR(run.pipe.angular_velocity, 2, 1e-15);
}

TEST(Drive, by_a_moment_turns_by_the_inertia_and_a_freedom_that_is_left_out_is_fixed)
{
  settings::StageSettings stage = drive();
  stage.drive.rotation.moment = 0.3;
  Driver run({stage});
  run.soil_pushes({7, 9});
  run.pipe.torque = -0.1;
  run.step();
  EXPECT_NEAR(run.pipe.angular_velocity, dt * 0.2 / (2 * 0.2 * 0.2 / 2), 1e-15);
  EXPECT_EQ(run.pipe.velocity, Vec<2>(0, 0));
}

TEST(Drive, holds_the_force_that_balances_the_soil_when_it_begins)
{
  settings::StageSettings stage = drive();
  stage.drive.y.hold = true;
  Driver run({push(0.5), stage});
  run.soil_pushes({0, 80});
  run.pipe.velocity.setZero();
  run.next_stage();
  run.step();
  EXPECT_NEAR(run.pipe.velocity[1], 0, 1e-15);
  run.pipe.reaction[1] = 90;
  run.step();
  EXPECT_NEAR(run.pipe.velocity[1], dt * 10 / 2, 1e-15);
}

TEST(Drive, is_what_push_and_drag_are_short_for)
{
  const Axes<2> axes;
  const auto same = [&](const settings::StageSettings& a, const settings::StageSettings& b) {
    const settings::StageDrives<2> one = drives_of(a, axes, false), other = drives_of(b, axes, false);
    for (std::size_t f = 0; f < one.size(); ++f) {
      EXPECT_EQ(one[f].by, other[f].by) << f;
      EXPECT_EQ(one[f].value, other[f].value) << f;
    }
  };
  settings::StageSettings down = drive(), along = drive();
  down.drive.y.velocity = -0.5;
  same(push(0.5), down);
  along.drive.x.velocity = 0.2;
  along.drive.y.hold = true;
  same(drag(0.2), along);
}

TEST(Drive, turns_the_body_of_a_push_or_a_drag_as_well)
{
  const Axes<2> axes;
  for (settings::StageSettings stage : {push(0.5), drag(0.2)}) {
    EXPECT_EQ(drives_of(stage, axes, true)[2].by, settings::FreedomDrive::By::free) << "as [rigid] says";
    stage.drive.rotation.spring = 3;
    const settings::StageDrives<2> sprung = drives_of(stage, axes, false);
    EXPECT_EQ(sprung[2].by, settings::FreedomDrive::By::force);
    EXPECT_EQ(sprung[2].value, 0);
    EXPECT_EQ(sprung[2].spring, 3);
    stage.drive.rotation = {};
    stage.drive.rotation.fixed = true;
    EXPECT_EQ(drives_of(stage, axes, true)[2].by, settings::FreedomDrive::By::velocity);
  }
}

TEST(Drive, ends_at_a_distance_whatever_its_direction)
{
  settings::StageSettings stage = drive();
  stage.drive.x.velocity = 3;
  stage.drive.y.velocity = 4;
  stage.until = {};
  stage.until.displacement = 0.05;
  EXPECT_NEAR(expected_time(stage), 0.01, 1e-15);
  Driver run({stage});
  for (int n = 0; n < 9; ++n) run.step();
  EXPECT_FALSE(run.ended());
  run.step();
  run.step();
  EXPECT_TRUE(run.ended());
}

TEST(Axes, are_against_gravity_along_the_nearest_axis)
{
  EXPECT_EQ(axes_of<2>({0, 0}).up, 1);
  const Axes<2> slope = axes_of<2>({3, -9});
  EXPECT_EQ(slope.up_vector(), Vec<2>(0, 1));
  EXPECT_EQ(slope.along, 0);
  const Axes<3> z_up = axes_of<3>({0, 0, -10});
  EXPECT_EQ(z_up.up_vector(), Vec<3>(0, 0, 1));
  EXPECT_EQ(z_up.along, 0);
  const Axes<2> turned = axes_of<2>({10, 0});
  EXPECT_EQ(turned.up_vector(), Vec<2>(-1, 0));
  EXPECT_EQ(turned.along, 1);
}

TEST(Axes, a_push_goes_down_and_its_embedment_is_along_gravity)
{
  settings::Case c = pipe_over_box({push(0.5)});
  c.gravity = {10, 0};  // down is +x, so the pipe's invert is its point of largest x
  auto problem = build<2>(c, ".", ".");
  EXPECT_NEAR(travel_of(problem.model, problem.state, 0).w, 1.2 - 1, 1e-15);  // the surface is x = 1 then
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity, Vec<2>(0.5, 0));
}

TEST(FreeRotation, follows_the_moment_of_the_soil_and_the_inertia)
{
  settings::Case c = pipe_over_box({drag(0.2), stage_of(settings::StageKind::free)});
  c.rigid[0].second.rotation = bodies::Rotation::free;
  auto problem = build<2>(c, ".", ".");
  bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
  pipe.torque = 0.3;
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_NEAR(pipe.angular_velocity, dt * 0.3 / (2 * 0.2 * 0.2 / 2), 1e-15);
  problem.state.stage.index = 1;  // it rests where nothing drives it
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_EQ(pipe.angular_velocity, 0);
}

TEST(Stage, drives_the_rigid_body_that_it_names_alone)
{
  settings::Case c = pipe_over_box({push(0.5)});
  c.rigid.push_back(c.rigid[0]);
  c.rigid[1].first = "other";
  c.rigid[1].second.shape = bodies::CircleSettings{{1.5, 1.3}, 0.4};
  c.stage[0].rigid = "other";
  auto problem = build<2>(c, ".", ".");
  drive_rigids(problem.model, problem.state, dt);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity, Vec<2>(0, 0));
  EXPECT_EQ(problem.state.rigid_bodies[1].velocity, Vec<2>(0, -0.5));
}

TEST(Stage, expected_time_follows_from_travel_speed_and_ramp)
{
  settings::StageSettings stage = push(0.5, 0.2);
  stage.until = {};
  stage.until.embedment = 0.1;
  EXPECT_NEAR(expected_time(stage), 0.3, 1e-15);
  stage.until.time = 0.25;
  EXPECT_NEAR(expected_time(stage), 0.25, 1e-15);
  settings::StageSettings along = drag(-0.5, 0.2);
  along.until = {};
  along.until.displacement = 0.1;
  EXPECT_NEAR(expected_time(along), 0.3, 1e-15);
  along.until = {};
  along.until.force = 3;
  EXPECT_EQ(expected_time(along), 0);
  along.kind = settings::StageKind::push;
  along.until = {};
  along.until.embedment = -0.5;  // above the bed
  EXPECT_EQ(expected_time(along), 0);
}

TEST(Gravity, grows_from_nothing_over_its_ramp)
{
  settings::Case c = pipe_over_box({push(0.5)});
  c.gravity = {1, -10};
  c.gravity_ramp = 2;
  const auto problem = build<2>(c, ".", ".");
  EXPECT_EQ(gravity_now(problem.model, 0), Vec<2>(0, 0));
  EXPECT_NEAR((gravity_now(problem.model, 0.5) - Vec<2>(0.25, -2.5)).norm(), 0, 1e-15);
  EXPECT_EQ(gravity_now(problem.model, 2), Vec<2>(1, -10));
  EXPECT_EQ(gravity_now(problem.model, 5), Vec<2>(1, -10));
}

}  // namespace
}  // namespace berm::problem::this_file
