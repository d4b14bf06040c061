// SPDX-License-Identifier: BSD-3-Clause
// What stands still from the begin of a stage on.
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

TEST(Push, after_a_drag_stands_still_along_x_at_once_whatever_its_ramp)
{
  settings::StageSettings hold = stage_of(settings::StageKind::drive, "rest");
  hold.drive.y.hold = true;
  hold.ramp = 0.1;
  for (const settings::StageSettings& stage : {push_by_force(30, 0.1), push(0.1, 0.1), hold}) {
    Driver run({drag(0.3), stage});
    for (int n = 0; n < 10; ++n) run.step();
    run.soil_pushes({-20, 70});
    run.next_stage();
    const Real u = run.pipe.displacement[0];
    for (int n = 0; n < 200; ++n) run.step();
    EXPECT_EQ(run.pipe.displacement[0], u) << stage.name;
  }
}

TEST(Drag, after_a_drag_turns_round_within_its_ramp)
{
  Driver run({drag(0.3), drag(-0.3, 0.1)});
  for (int n = 0; n < 10; ++n) run.step();
  run.next_stage();
  for (int n = 0; n < 50; ++n) run.step();
  EXPECT_NEAR(run.pipe.velocity[0], 0, 1e-12);
}

}  // namespace
}  // namespace berm::problem::this_file
