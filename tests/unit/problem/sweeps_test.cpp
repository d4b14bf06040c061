// SPDX-License-Identifier: BSD-3-Clause
#include "problem/sweeps.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

Case swept(int sweeps, Real pause)
{
  Case c;
  StageSettings push, sweep;
  push.name = "push";
  push.kind = StageKind::push;
  sweep.name = "sweep";
  sweep.kind = StageKind::sweep;
  sweep.velocity = -0.2;
  sweep.amplitude = 0.06;
  sweep.sweeps = sweeps;
  sweep.pause = pause;
  sweep.ramp = 0.001;
  sweep.vertical_force = 300;
  c.stage = {push, sweep};
  return c;
}

TEST(sweeps, become_drags_out_and_back)
{
  Case c = swept(3, 0);
  expand_sweeps(c);
  ASSERT_EQ(c.stage.size(), 4u);
  const Real velocities[] = {-0.2, 0.2, -0.2};
  for (int k = 1; k <= 3; ++k) {
    const StageSettings& drag = c.stage[k];
    EXPECT_EQ(drag.name, "sweep_" + std::to_string(k));
    EXPECT_EQ(drag.kind, StageKind::drag);
    EXPECT_EQ(drag.velocity, velocities[k - 1]);
    EXPECT_EQ(drag.until.displacement, 0.06);
    EXPECT_EQ(drag.vertical_force, 300);
    EXPECT_EQ(drag.ramp, 0.001);
    EXPECT_FALSE(drag.amplitude || drag.sweeps != 0 || drag.pause != 0);
  }
}

TEST(sweeps, stand_still_between_two_of_them_where_they_pause)
{
  Case c = swept(2, 0.5);
  expand_sweeps(c);
  ASSERT_EQ(c.stage.size(), 4u) << "there is no pause after the last";
  EXPECT_EQ(c.stage[2].name, "sweep_1_pause");
  EXPECT_EQ(c.stage[2].velocity, 0);
  EXPECT_EQ(c.stage[2].until.time, 0.5);
  EXPECT_FALSE(c.stage[2].until.displacement);
  EXPECT_EQ(c.stage[2].vertical_force, 300) << "V is held";
}

TEST(sweeps, that_supports_name_are_all_their_drags)
{
  Case c = swept(2, 0);
  c.support.emplace_back("wall", boundary::SupportSettings{});
  c.support[0].second.stages = {"push", "sweep"};
  expand_sweeps(c);
  EXPECT_EQ(c.support[0].second.stages, (std::vector<std::string>{"push", "sweep_1", "sweep_2"}));
}

TEST(sweeps, have_names_that_no_other_stage_has)
{
  Case c = swept(2, 0);
  c.stage[0].name = "sweep_2";
  EXPECT_THROW(expand_sweeps(c), InputError);
}

}  // namespace
}  // namespace berm::problem::this_file
