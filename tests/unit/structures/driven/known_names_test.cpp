// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/known_names.hpp"

#include "samples/lived_pipe.hpp"
#include "samples/names_before_a_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

TEST(KnownNames, hold_all_that_runs_have)
{
  for (const record::RunRecord& run : {MadeRun{}.record(), lived_pipe()}) EXPECT_EQ(surprises_of(run), std::vector<std::string>{});
}

TEST(KnownNames, do_not_hold_what_no_run_of_the_case_can_have)
{
  const settings::Case c = MadeRun{}.settings();
  EXPECT_TRUE(knows(c, "V_at_w_0.35D"));
  EXPECT_TRUE(knows(c, "H_over_V_at_u_1.5D"));
  EXPECT_TRUE(knows(c, "berm_height"));
  for (const char* name : {"Hmax", "back.H_max", "u_largest", "uplift.R_max", "q_t_end", "H_at_u_0.35D", "V_at_w_0.12D", "V_at_w_0.10D",
                           "V_at_w_0D", "push.V_end", "flooded.V", "laid.V"})
    EXPECT_FALSE(knows(c, name)) << name;
}

TEST(KnownNames, of_a_drag_by_force_are_those_of_where_it_goes_and_not_of_what_the_soil_resists)
{
  settings::Case c = MadeRun{}.settings();
  settings::StageSettings& drag = c.stage.back();
  drag.velocity.reset();
  drag.force = 300;
  for (const char* name : {"u_largest", "w_end", "time_to_0.5D", "H_max", "H_at_u_1D", "H_end_of_drag", "V_in_drag"})
    EXPECT_TRUE(knows(c, name)) << name;
  for (const char* name : {"H_residual", "H_breakout", "u_at_breakout", "H_berm"}) EXPECT_FALSE(knows(c, name)) << name;
  drag.load_times = {0, 1};
  drag.load_factors = {0, 1};
  for (const char* name : {"u_largest", "H_end_of_drag", "V_in_drag"}) EXPECT_TRUE(knows(c, name)) << name;
  for (const char* name : {"H_max", "H_at_u_1D", "H_noise", "over_penetration"}) EXPECT_FALSE(knows(c, name)) << name;
}

TEST(KnownNames, of_pushes_are_those_of_the_way_down_of_a_push_by_force_that_may_unload_and_of_a_lift)
{
  settings::Case c = MadeRun{}.settings();
  c.stage.pop_back();
  settings::StageSettings lift = MadeRun::stage_of("uplift", settings::StageKind::push);
  lift.velocity = -0.1;
  c.stage.push_back(lift);
  for (const char* name : {"V_end_of_push", "uplift.R_max", "uplift.V_end", "V_at_travel_0.01D"}) EXPECT_TRUE(knows(c, name)) << name;
  for (const char* name : {"H_max", "push.V_end", "V_at_travel_0.04D"}) EXPECT_FALSE(knows(c, name)) << name;
  std::erase_if(c.stage, [](const settings::StageSettings& stage) { return stage.name == "push"; });
  EXPECT_FALSE(knows(c, "V_end_of_push")) << "nothing goes down";
}

TEST(KnownNames, of_states_are_those_that_the_roles_of_stages_or_the_drags_that_lay_the_pipe_make)
{
  settings::Case c = lived_pipe().settings;
  EXPECT_TRUE(knows(c, "laid.V"));
  EXPECT_FALSE(knows(c, "flooded.V"));
  c.stage[3].role = settings::StageRole::flooded;
  EXPECT_TRUE(knows(c, "flooded.V"));
  EXPECT_FALSE(knows(c, "laid.V")) << "where a role is said none is guessed";
}

}  // namespace
}  // namespace berm::driven::this_file
