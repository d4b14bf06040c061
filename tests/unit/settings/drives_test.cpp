// SPDX-License-Identifier: BSD-3-Clause
#include "settings/drives.hpp"

#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real step = 1e-4;  // s

/// A box in space, askew, of 2 kg without any soil near it, driven by one stage.
Problem<3> box_in_space(const settings::StageSettings& stage)
{
  settings::Case c = pipe_over_box({stage});
  c.geometry = settings::Geometry::space;
  mesh::BoxMesh box;
  box.size = {2, 2, 2};
  box.cells = {2, 2, 2};
  c.mesh = box;
  c.rigid[0].second.shape = bodies::BoxSettings{{0, 5, 0}, {1, 2, 3}, 0, {0.3, 0.2, 0.1}};
  return build<3>(c, ".", ".");
}

void step_body(Problem<3>& problem)
{
  drive_rigids(problem.model, problem.state, step);
  move_body(problem.model.rigid_bodies[0], problem.state.rigid_bodies[0], step);
  problem.state.time += step;
}

TEST(Spring, besides_a_force_lets_the_body_swing_about_where_both_balance)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.x.force = 3;
  stage.drive.x.spring = 50;
  auto problem = box_in_space(stage);
  begin_stage(problem.model, problem.state);
  const Real omega = std::sqrt(50. / 2);
  for (int n = 0; n < 20000; ++n) {  // 1.6 periods
    step_body(problem);
    const Real t = problem.state.time;
    // m x'' = F - k x; the steps are off by omega dt / 2 of the velocity's phase, 2.5e-4.
    ASSERT_NEAR(problem.state.rigid_bodies[0].displacement[0], 3. / 50 * (1 - std::cos(omega * t)), 3e-4 * 3. / 50) << t;
  }
  EXPECT_EQ(problem.state.rigid_bodies[0].displacement[1], 0);
}

TEST(Spring, of_a_rotation_lets_a_body_whose_axis_is_held_swing)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.rotation_y.moment = 0.2;
  stage.drive.rotation_y.spring = 4;
  auto problem = box_in_space(stage);
  begin_stage(problem.model, problem.state);
  const bodies::RigidBody<3>& body = problem.model.rigid_bodies[0];
  const Real inertia = times_inertia(body, problem.state.rigid_bodies[0], Vec<3>::UnitY())[1], omega = std::sqrt(4 / inertia);
  for (int n = 0; n < 20000; ++n) {
    step_body(problem);
    const Vec<3> angle = rotation_of(problem.state.rigid_bodies[0].orientation);
    ASSERT_NEAR(angle[1], 0.2 / 4 * (1 - std::cos(omega * problem.state.time)), 3e-4 * 0.2 / 4) << n;
    ASSERT_NEAR(std::hypot(angle[0], angle[2]), 0, 1e-12);
  }
}

TEST(Spring, begins_where_the_body_is_when_its_stage_begins)
{
  settings::StageSettings first = stage_of(settings::StageKind::drive), second = stage_of(settings::StageKind::drive);
  first.drive.z.velocity = 1;
  first.drive.rotation_x.velocity = 2;
  second.drive.z.spring = 10;
  second.drive.rotation_x.spring = 10;
  auto problem = box_in_space(first);
  problem.model.stages.push_back(second);
  problem.model.driven.push_back(0);
  begin_stage(problem.model, problem.state);
  for (int n = 0; n < 1000; ++n) step_body(problem);
  problem.state.rigid_bodies[0].velocity.setZero();
  problem.state.rigid_bodies[0].angular_velocity.setZero();
  problem.state.stage.index = 1;
  begin_stage(problem.model, problem.state);
  step_body(problem);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity.norm(), 0);  // no spring is stretched
  EXPECT_NEAR(problem.state.rigid_bodies[0].angular_velocity.norm(), 0, 1e-15);
}

TEST(FreeFreedom, is_moved_by_the_soil_alone_and_needs_inertia)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.z.free = true;
  const auto drives = drives_of<3>(stage, axes_of<3>({0, -10, 0}), false);
  EXPECT_TRUE(has_force<3>(drives));
  EXPECT_FALSE(has_moment<3>(drives));
  auto problem = box_in_space(stage);
  begin_stage(problem.model, problem.state);
  problem.state.rigid_bodies[0].reaction = {7, 8, 9};
  step_body(problem);
  EXPECT_NEAR(problem.state.rigid_bodies[0].velocity[2], step * 9 / 2, 1e-18);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity[0], 0);
}

TEST(DriveAtAPoint, moves_the_point_along_one_axis_by_an_impulse_that_turns_the_body_as_well)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.x.velocity = 1;
  stage.drive.y.free = stage.drive.z.free = true;
  stage.drive.rotation_x.free = stage.drive.rotation_y.free = stage.drive.rotation_z.free = true;
  stage.drive.point = {0.3, 6.2, -0.4};
  auto problem = box_in_space(stage);
  begin_stage(problem.model, problem.state);
  const bodies::RigidBody<3>& body = problem.model.rigid_bodies[0];
  const bodies::RigidState<3>& state = problem.state.rigid_bodies[0];
  drive_rigids(problem.model, problem.state, step);
  const Vec<3> arm(0.3, 1.2, -0.4), impulse(2 * state.velocity[0], 0, 0);  // of 2 kg
  EXPECT_NEAR((state.velocity + bodies::cross(state.angular_velocity, arm))[0], 1, 1e-12);
  EXPECT_NEAR((times_inertia(body, bodies::Pose<3>{}, state.angular_velocity) - bodies::cross(arm, impulse)).norm(), 0, 1e-12);
  EXPECT_NEAR(std::hypot(state.velocity[1], state.velocity[2]), 0, 1e-12);
  for (int n = 0; n < 1000; ++n) {
    step_body(problem);
    const Vec<3> point = center_now<3>(body, state) + state.orientation.matrix() * arm;
    ASSERT_NEAR(velocity_at<3>(body, state, point)[0], 1, 2 * step * state.angular_velocity.squaredNorm() * arm.norm())
        << n;  // it has moved since
  }
}

TEST(DriveAtAPoint, holds_a_point_about_which_the_body_swings_with_the_period_of_a_pendulum)
{
  // A bar whose upper end is held, under a force at its centre: that of gravity, given as the soil's.
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.rotation_z.free = true;
  stage.drive.point = {0, 6, 0};
  settings::Case c = pipe_over_box({stage});
  c.geometry = settings::Geometry::space;
  mesh::BoxMesh box;
  box.size = {2, 2, 2};
  box.cells = {2, 2, 2};
  c.mesh = box;
  c.rigid[0].second.shape = bodies::BoxSettings{{0, 5, 0}, {0.2, 2, 0.2}};
  auto problem = build<3>(c, ".", ".");
  begin_stage(problem.model, problem.state);
  bodies::RigidState<3>& state = problem.state.rigid_bodies[0];
  state.reaction = {0, -2 * 10., 0};
  state.orientation.turn_by({0, 0, 0.01});
  state.displacement = {std::sin(0.01), 1 - std::cos(0.01), 0};
  const Real inertia = 2 * (4 + 0.04) / 12 + 2 * 1, omega = std::sqrt(2 * 10. / inertia);
  for (int n = 1; n <= 20000; ++n) {
    step_body(problem);
    // First order in the step: the phase is off by a step, and the end drifts by the square of the angle in each.
    ASSERT_NEAR(rotation_of(state.orientation)[2], 0.01 * std::cos(omega * n * step), 1e-3 * 0.01) << n;
  }
  EXPECT_NEAR((state.displacement + state.orientation.matrix() * Vec<3>(0, 1, 0) - Vec<3>(0, 1, 0)).norm(), 0, 1e-6);
}

TEST(DriveAtAPoint, ends_at_the_distance_of_that_point)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drive);
  stage.drive.rotation_z.velocity = 1;
  stage.drive.point = {0, 6, 0};  // x, y and z are fixed there
  stage.until = {};
  stage.until.displacement = 0.01;
  auto problem = box_in_space(stage);
  begin_stage(problem.model, problem.state);
  for (int n = 0; n < 1000; ++n) step_body(problem);
  EXPECT_GT(problem.state.rigid_bodies[0].displacement.norm(), 0.09);  // the centre goes around the point, 1 m times 0.1
  EXPECT_FALSE(stage_ended(problem.model, problem.state));
  problem.state.rigid_bodies[0].displacement[0] += 0.011;
  EXPECT_TRUE(stage_ended(problem.model, problem.state));
}

TEST(RotationBetween, orientations_is_the_rotation_vector_that_takes_one_to_the_other)
{
  bodies::Orientation<3> from, to;
  from.turn_by({0.4, -2, 1.3});
  to = from;
  to.turn_by({-0.2, 0.7, 0.5});
  EXPECT_NEAR((rotation_between(from, to) - Vec<3>(-0.2, 0.7, 0.5)).norm(), 0, 1e-15);
  EXPECT_EQ(rotation_between(from, from).norm(), 0);
}

}  // namespace
}  // namespace berm::problem::this_file
