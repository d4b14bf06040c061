// SPDX-License-Identifier: BSD-3-Clause
#include "fem/load_steps.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A plate of 0.4 m that sticks to the middle of an elastic block, so that all answers are linear.
settings::Case plate_to_drive(settings::StageSettings stage)
{
  settings::Case c = plate_on_block(elastic_soil(), 0.4, {10, 5});
  c.contact[0].second.scheme = contact::Scheme::tied;
  stage.name = "drive";
  stage.kind = settings::StageKind::drive;
  if (!stage.until.displacement) stage.until.time = 1;
  c.stage = {stage};
  return c;
}

struct Driven {
  bodies::RigidState<2> plate;
  Real time, energy_error;
};

Driven driven(const settings::Case& c)
{
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  do steps.advance();
  while (!stage_ended(problem.model.model, problem.state.state));
  const problem::Totals<2>& t = problem.state.state.ledger.totals;
  return {problem.state.state.rigid_bodies[problem.model.model.main_rigid], problem.state.state.time,
          (t.internal + t.friction - t.external) / t.external};
}

TEST(LoadStepsDrive, turns_a_body_by_its_angular_velocity_and_the_soil_resists)
{
  settings::StageSettings stage;
  stage.drive.rotation.velocity = -0.001;
  const Driven turned = driven(plate_to_drive(stage));
  EXPECT_NEAR(turned.plate.orientation.angle, -0.001, 1e-15);
  EXPECT_EQ(turned.plate.displacement.norm(), 0);
  EXPECT_GT(turned.plate.torque, 0) << "against the rotation";
  EXPECT_NEAR(turned.energy_error, 0, 1e-6);
}

TEST(LoadStepsDrive, turns_it_as_far_by_the_moment_that_its_rotation_needs_where_it_is_free)
{
  settings::StageSettings by_velocity;
  by_velocity.drive.rotation.velocity = -0.001;
  by_velocity.drive.x.free = true;
  by_velocity.drive.y.free = true;
  const Driven turned = driven(plate_to_drive(by_velocity));
  EXPECT_NEAR(turned.plate.reaction.norm(), 0, 1e-6 * turned.plate.torque / 0.4);
  EXPECT_GT(turned.plate.displacement[0], 0) << "the base stays, and the centre above it goes to the right";
  settings::StageSettings by_moment;
  by_moment.drive.rotation.moment = -turned.plate.torque;
  by_moment.drive.x.free = true;
  by_moment.drive.y.free = true;
  const Driven again = driven(plate_to_drive(by_moment));
  const Real tolerance = settings::FemSettings{}.tolerance;  // of the unbalanced forces
  EXPECT_NEAR(again.plate.orientation.angle / turned.plate.orientation.angle, 1, tolerance);
  EXPECT_NEAR(again.plate.torque / turned.plate.torque, 1, tolerance);
  EXPECT_NEAR(again.plate.displacement[0] / turned.plate.displacement[0], 1, tolerance);
}

TEST(LoadStepsDrive, ends_at_a_distance_in_any_direction)
{
  settings::StageSettings stage;
  stage.drive.x.velocity = 0.3;
  stage.drive.y.velocity = -0.4;
  stage.until.displacement = 1e-3;
  const Driven moved = driven(plate_to_drive(stage));
  EXPECT_NEAR(moved.plate.displacement.norm(), 1e-3, 1e-15);
  EXPECT_NEAR(moved.time, 2e-3, 1e-12);
}

TEST(LoadStepsDrive, holds_a_force_while_it_drags)
{
  settings::StageSettings push, drag;
  push.drive.y.velocity = -1e-3;
  drag.drive.x.velocity = 1e-4;
  drag.drive.y.hold = true;
  settings::Case c = plate_to_drive(push);
  const Real V = driven(c).plate.reaction[1];
  c.stage.push_back(plate_to_drive(drag).stage[0]);
  c.stage[1].name = "drag";
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  do do
      steps.advance();
    while (!stage_ended(problem.model.model, problem.state.state));
  while (steps.next_stage());
  const bodies::RigidState<2>& plate = problem.state.state.rigid_bodies[problem.model.model.main_rigid];
  EXPECT_NEAR(plate.reaction[1] / V, 1, 1e-3);
  EXPECT_NEAR(plate.displacement[0], 1e-4, 1e-15);
  EXPECT_GT(V, 0);
}

}  // namespace
}  // namespace berm::fem::this_file
