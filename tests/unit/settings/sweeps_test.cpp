// SPDX-License-Identifier: BSD-3-Clause
#include "settings/sweeps.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::settings::this_file {
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

/// "lay", and then "heat" and "cool" so many times.
Case heated(int times)
{
  Case c;
  for (const char* name : {"lay", "heat", "cool"}) {
    c.stage.emplace_back();
    c.stage.back().name = name;
  }
  c.stage.back().repeat = times;
  c.stage.back().repeat_from = "heat";
  return c;
}

TEST(repeats, write_stages_behind_themselves)
{
  Case c = heated(3);
  boundary::SupportSettings support;
  support.stages = {"cool", "lay"};
  support.motion.emplace().stages = {"heat"};
  c.support = {{"wall", support}};
  const std::vector<std::size_t> origins = expand_repeats(c);
  const std::vector<std::string> names = {"lay", "heat", "cool", "heat_2", "cool_2", "heat_3", "cool_3"};
  ASSERT_EQ(c.stage.size(), names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    EXPECT_EQ(c.stage[k].name, names[k]);
    EXPECT_EQ(c.stage[k].repeat, 1);
  }
  EXPECT_EQ(origins, (std::vector<std::size_t>{0, 1, 2, 1, 2, 1, 2}));
  EXPECT_EQ(c.support[0].second.stages, (std::vector<std::string>{"cool", "cool_2", "cool_3", "lay"}));
  EXPECT_EQ(c.support[0].second.motion->stages, (std::vector<std::string>{"heat", "heat_2", "heat_3"}));
}

TEST(repeats, that_are_not_clear_are_refused)
{
  Case c = heated(3);
  c.stage.back().repeat_from = "melt";
  EXPECT_THROW(expand_repeats(c), KeyError);
  c = heated(1);
  EXPECT_THROW(expand_repeats(c), KeyError) << "from, but not how often";
  c = heated(2);
  c.stage[1].repeat = 2;
  EXPECT_THROW(expand_repeats(c), KeyError) << "within another";
  c = heated(2);
  c.stage[0].name = "heat_2";
  EXPECT_THROW(expand_repeats(c), KeyError) << "the name is taken";
  c = heated(2);
  c.stage[1].kind = StageKind::sweep;
  EXPECT_THROW(expand_repeats(c), KeyError) << "a sweep has its number of drags";
  c = heated(2);
  c.stage[1].name = std::string(max_stage_name, 'h');
  EXPECT_THROW(expand_repeats(c), KeyError) << "the name would be too long";
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
}  // namespace berm::settings::this_file
