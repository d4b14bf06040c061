// SPDX-License-Identifier: BSD-3-Clause
// Limits that know where the body goes, and how a drive comes to its force.
#include "samples/sample_driver.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

settings::StageSettings push_by_force(Real force, Real ramp)
{
  settings::StageSettings stage = stage_of(settings::StageKind::push, "unload");
  stage.force = force;
  stage.ramp = ramp;
  return stage;
}

/// How far beyond its limit a push ends, over the limit, in soil whose V grows from the surface on as K w^n; K so that the limit is reached at `w` from there.
Real beyond_limit(Real n, Real w, Real velocity)
{
  constexpr Real limit = 500, surface = 0.02;  // N/m; m that the push goes before it touches
  settings::StageSettings stage = push(velocity, 0.02);
  stage.until = {};
  stage.until.force = limit;
  Driver run({stage});
  run.problem.model.rigid_bodies[0].fading = {infinity, 0.1};
  begin_stage(run.problem.model, run.problem.state);
  run.problem.state.dt = dt;
  Real force = 0;
  for (int k = 0; k < 100000 && !run.ended(); ++k) {
    force = limit * std::pow(std::max(Real(0), -run.pipe.displacement[1] - surface) / w, n);
    run.pipe.reaction = {0, force};
    drive_rigids(run.problem.model, run.problem.state, dt);
    move_rigids(run.problem.model, run.problem.state);
    run.problem.state.time += dt;
  }
  EXPECT_TRUE(run.ended());
  EXPECT_NEAR(beyond_force_limit(run.problem.model, run.problem.state), force / limit - 1, 0.01) << "what berm says of it";
  return force / limit - 1;
}

TEST(Stage, ends_within_two_percent_of_its_limit_of_force_however_stiff_the_soil_and_fast_the_drive)
{
  // The mean reaction lags by 0.1 s, in which the body would go 0.1 to 10 times the way to the limit.
  for (const Real velocity : {1e-3, 0.01, 0.1})
    for (const Real n : {0.5, 1., 1.5}) {
      EXPECT_LT(beyond_limit(n, 1e-3, velocity), 0.02) << velocity << ", V goes with w^" << n;
      EXPECT_GT(beyond_limit(n, 1e-3, velocity), -0.001) << velocity << ", V goes with w^" << n;
    }
}

TEST(Stage, with_a_limit_of_force_keeps_its_velocity_where_the_limit_is_far)
{
  settings::StageSettings stage = push(0.1);
  stage.until.force = 500;
  Driver run({stage});
  run.problem.model.rigid_bodies[0].fading = {infinity, 0.1};
  run.soil_pushes({0, 100});
  EXPECT_EQ(velocity_factor(run.problem.model, run.problem.state, 0.1), 1) << "nothing is known of the soil yet";
  run.problem.state.stage.approach = {0, 1, 1};  // 100 N/m in 1 m: V grows by 1 N/m while its mean fades
  EXPECT_EQ(velocity_factor(run.problem.model, run.problem.state, 0.1), 1);
  run.problem.state.stage.approach = {0, 1e-3, 1e-3};  // 1000 N/m
  EXPECT_NEAR(velocity_factor(run.problem.model, run.problem.state, 0.1), (1.01 * 500 - 100) / (2 * 1000), 1e-12);
}

TEST(Stage, that_lifts_its_body_ends_where_w_has_fallen_to_its_embedment)
{
  settings::StageSettings stage = push(-0.5);
  stage.until = {};
  stage.until.embedment = 0.07;
  Driver run({push(0.5), stage});
  while (run.w() < 0.1) run.step();
  run.next_stage();
  int steps = 0;
  while (!run.ended() && steps < 1000) run.step(), ++steps;
  EXPECT_NEAR(run.w(), 0.07, 0.5 * dt);
  EXPECT_NEAR(steps, 60, 1);
}

TEST(Stage, that_lifts_its_body_ends_where_V_has_fallen_to_its_force)
{
  for (const Real limit : {25., -25.}) {
    settings::StageSettings up = push(-0.5);
    up.until = {};
    up.until.force = limit;
    Driver run({push(0.5), up});
    run.step();
    run.soil_pushes({0, 100});
    run.next_stage();
    run.soil_pushes({0, limit + 0.1});
    EXPECT_FALSE(run.ended());
    run.soil_pushes({0, limit});
    EXPECT_TRUE(run.ended());
  }
}

TEST(Stage, that_unloads_by_a_force_ends_where_V_has_fallen_to_its_limit)
{
  settings::StageSettings unload = push_by_force(20, 0.1);
  unload.until = {};
  unload.until.force = 50;
  Driver run({push(0.5), unload});
  run.step();
  run.soil_pushes({0, 100});
  run.next_stage();
  EXPECT_FALSE(run.ended()) << "V is more than the limit, and falls";
  run.soil_pushes({0, 49});
  EXPECT_TRUE(run.ended());
}

TEST(Stage, counts_a_displacement_along_its_velocity)
{
  settings::StageSettings back = drag(-0.2, 0.2);
  back.until = {};
  back.until.displacement = 0.005;
  Driver run({drag(0.2), back});
  for (int n = 0; n < 100; ++n) run.step();
  run.next_stage();
  const Real u = run.pipe.displacement[0];
  while (!run.ended() && run.problem.state.time < 10) run.step();
  EXPECT_NEAR(run.pipe.displacement[0], u - 0.005, 0.2 * dt) << "and not after the first 5 mm, which it coasts along x";
}

}  // namespace
}  // namespace berm::problem::this_file
