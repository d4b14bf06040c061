// SPDX-License-Identifier: BSD-3-Clause
#include "fem/load_steps.hpp"
#include "problem/stages.hpp"
#include "samples/fem_sample_bed.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

TEST(DragOfFiniteElements, with_a_vertical_velocity_goes_straight_in_that_direction)
{
  settings::Case c = bed_around(pipe_at(0.1));
  settings::StageSettings drag;
  drag.name = "drag";
  drag.kind = settings::StageKind::drag;
  drag.velocity = 0.1;
  drag.vertical_velocity = 0.05;
  drag.ramp = 0.01;
  drag.until.time = 0.03;
  c.stage = {drag};
  const TemporaryFolder folder;
  FemProblem problem = build_fem(c, ".", folder.path());
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  const bodies::RigidState<2>& pipe = problem.state.state.rigid_bodies[0];
  do {
    ASSERT_TRUE(steps.advance().converged);
    EXPECT_NEAR(pipe.displacement[1], -0.5 * pipe.displacement[0], 1e-15);
  } while (!stage_ended(problem.model.model, problem.state.state));
  EXPECT_NEAR(pipe.displacement[0], 0.1 * (0.03 - 0.005), 1e-15);  // half the ramp is lost
}

}  // namespace
}  // namespace berm::fem::this_file
