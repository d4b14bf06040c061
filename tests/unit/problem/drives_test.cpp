// SPDX-License-Identifier: BSD-3-Clause
#include "problem/drives.hpp"

#include "sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real step = 1e-4;  // s

/// A box in space, askew, of 2 kg without any soil near it, driven by one stage.
Problem<3> box_in_space(const StageSettings& stage)
{
  Case c = pipe_over_box({stage});
  c.geometry = Geometry::space;
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
  move_body(problem.state.rigid_bodies[0], step);
  problem.state.time += step;
}

TEST(Spring, besides_a_force_lets_the_body_swing_about_where_both_balance)
{
  StageSettings stage = stage_of(StageKind::drive);
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
  StageSettings stage = stage_of(StageKind::drive);
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
  StageSettings first = stage_of(StageKind::drive), second = stage_of(StageKind::drive);
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
  StageSettings stage = stage_of(StageKind::drive);
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
