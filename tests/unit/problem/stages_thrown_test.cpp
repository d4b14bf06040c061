// SPDX-License-Identifier: BSD-3-Clause
// Free bodies that begin with a velocity.
#include "samples/sample_driver.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// The pipe of 2 kg/m, free, thrown to the right and down, after so many stages in which all rests.
settings::Case thrown_pipe(int geostatic_stages)
{
  std::vector<settings::StageSettings> stages(geostatic_stages, stage_of(settings::StageKind::geostatic, "rest"));
  stages.push_back(stage_of(settings::StageKind::free, "fall"));
  settings::Case c = pipe_over_box(stages);
  c.gravity = {0, -9.81};
  c.gravity_ramp = 0;
  c.rigid[0].second.motion = bodies::Motion::free;
  c.rigid[0].second.velocity = {0.5, -2};
  return c;
}

TEST(ThrownBody, goes_as_newton_has_it)
{
  for (const int rests : {0, 2}) {
    Problem<2> problem = build<2>(thrown_pipe(rests), ".", ".");
    bodies::RigidState<2>& pipe = problem.state.rigid_bodies[0];
    const auto go = [&] {
      drive_rigids(problem.model, problem.state, dt);
      move_body(problem.model.rigid_bodies[0], pipe, dt);
      problem.state.time += dt;
    };
    for (int k = 0; k < rests; ++k) {
      for (int n = 0; n < 10; ++n) go();
      ASSERT_TRUE(pipe.displacement.isZero(0)) << "it is held in a geostatic stage";
      ++problem.state.stage.index;
      begin_stage(problem.model, problem.state);
    }
    const Real begin = problem.state.time;
    for (int n = 0; n < 300; ++n) {
      go();
      const Real t = problem.state.time - begin;
      ASSERT_NEAR(pipe.displacement[0], 0.5 * t, 1e-14);
      // v0 t + g t^2/2, and g t dt/2: a step goes by the velocity at its end.
      ASSERT_NEAR(-pipe.displacement[1], 2 * t + 9.81 * t * t / 2 + 9.81 * t * dt / 2, 1e-13);
      const Real kinetic = kinetic_energy(problem.model.rigid_bodies[0], pipe);
      ASSERT_NEAR(problem.state.ledger.totals.external, kinetic, 1e-12 * kinetic) << "of what threw it and of gravity";
    }
  }
}

TEST(ThrownBody, is_thrown_once)
{
  settings::Case c = thrown_pipe(1);
  c.stage.push_back(stage_of(settings::StageKind::free, "later"));
  Problem<2> problem = build<2>(c, ".", ".");
  EXPECT_TRUE(problem.state.rigid_bodies[0].velocity.isZero(0));
  ++problem.state.stage.index;
  begin_stage(problem.model, problem.state);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity, Vec<2>(0.5, -2));
  problem.state.rigid_bodies[0].velocity = {0.1, 0.1};
  ++problem.state.stage.index;
  begin_stage(problem.model, problem.state);
  EXPECT_EQ(problem.state.rigid_bodies[0].velocity, Vec<2>(0.1, 0.1));
}

}  // namespace
}  // namespace berm::problem::this_file
