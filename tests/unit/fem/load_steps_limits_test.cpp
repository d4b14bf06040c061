// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/methods/fem/load_steps.cpp: loads that vary together, and limits of a body that is lifted.
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

settings::Case plate_with(std::vector<settings::StageSettings> stages)
{
  settings::Case c = plate_on_block(plastic_soil(1e3, 0, 0), 0.4, {10, 5});
  c.contact[0].second.friction_angle = std::atan(0.5);
  c.stage = std::move(stages);
  return c;
}

/// Calls look() after each increment.
template <class Look>
bodies::RigidState<2> state_after(const settings::Case& c, const Look& look)
{
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  do do {
      steps.advance();
      look(problem.state.state, problem.state.state.rigid_bodies[problem.model.model.main_rigid]);
    } while (!stage_ended(problem.model.model, problem.state.state));
  while (steps.next_stage());
  return problem.state.state.rigid_bodies[problem.model.model.main_rigid];
}

TEST(LoadStepsLoads, follow_the_columns_of_a_load_history_and_miss_no_turning_point)
{
  settings::StageSettings stage = resting(3);
  stage.kind = settings::StageKind::drag;
  stage.load_times = {0, 1, 2, 3};
  stage.loads.of("H") = {0, 100, -100, 0};
  stage.loads.of("V") = {0, 800, 400, 400};
  Real largest = 0;
  state_after(plate_with({stage}), [&](const problem::State<2>& state, const bodies::RigidState<2>& plate) {
    const Real H = load_of_column(stage, 0, state.time), V = load_of_column(stage, 1, state.time);
    EXPECT_NEAR(-plate.reaction[0], H, 2 + 0.01 * V) << state.time;  // the tolerance of the unbalanced forces
    EXPECT_NEAR(plate.reaction[1], V, 2 + 0.01 * V) << state.time;
    largest = std::max(largest, plate.reaction[1]);
  });
  EXPECT_NEAR(largest, 800, 8) << "an increment ends where the history turns";
}

TEST(LoadStepsLoads, miss_no_turning_point_of_a_load_history_that_runs_faster)
{
  settings::StageSettings stage = resting(0.3);
  stage.kind = settings::StageKind::drag;
  stage.time_scale = 0.1;
  stage.load_times = {0, 1, 2, 3};
  stage.loads.of("H") = {0, 100, -100, 0};
  stage.loads.of("V") = {0, 800, 400, 400};
  Real largest = 0;
  state_after(plate_with({stage}),
              [&](const auto&, const bodies::RigidState<2>& plate) { largest = std::max(largest, plate.reaction[1]); });
  EXPECT_NEAR(largest, 800, 8);
}

TEST(LoadStepsLoads, multiply_the_force_of_a_push_by_factors)
{
  settings::StageSettings stage = resting(2);
  stage.kind = settings::StageKind::push;
  stage.force = 400;
  stage.load_times = {0, 1, 2};
  stage.load_factors = {0, 2, 1};
  Real largest = 0;
  const bodies::RigidState<2> end = state_after(
      plate_with({stage}), [&](const auto&, const bodies::RigidState<2>& plate) { largest = std::max(largest, plate.reaction[1]); });
  EXPECT_NEAR(largest, 800, 8);
  EXPECT_NEAR(end.reaction[1], 400, 8);
}

TEST(LoadStepsLimits, of_a_plate_that_is_lifted_are_met_from_above)
{
  settings::StageSettings down = pushing(), up = pushing();
  down.until.embedment = 0.02;
  up.name = "up";
  up.velocity = -1;
  up.until.embedment = 0.0193;
  EXPECT_NEAR(state_after(plate_with({down, up}), [](const auto&, const auto&) {}).displacement[1], -0.0193, 1e-15);
  up.until = {};
  up.until.force = 700;
  const Real V = state_after(plate_with({down, up}), [](const auto&, const auto&) {}).reaction[1];
  EXPECT_LE(V, 700);
  EXPECT_GE(V, 700 * (1 - 1e-4));  // what the stage allows beyond
}

}  // namespace
}  // namespace berm::fem::this_file
