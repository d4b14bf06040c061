// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/states.hpp"

#include "samples/lived_pipe.hpp"
#include "structures/driven/driven_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

constexpr Real D = 0.02;

TEST(States, of_a_pipe_are_touchdown_laid_operation_and_the_end_of_each_sweep)
{
  const States states = states_of(lived_pipe());
  std::vector<std::string> names;
  for (const State& state : states) names.push_back(state.name);
  EXPECT_EQ(names, (std::vector<std::string>{"touchdown", "laid", "operation", "after_sweep_1", "after_sweep_2"}));
  EXPECT_NEAR(states[0].w, 0.1 * D, 1e-9);
  EXPECT_NEAR(states[1].w, 0.3 * D, 1e-9);
  EXPECT_NEAR(states[1].V, 800, 1e-9);
  EXPECT_NEAR(states[2].w, 0.29 * D, 1e-9);
  EXPECT_NEAR(states[2].V, 300, 1e-9);
  EXPECT_EQ(states[2].origin, "end of stage unload, before sweep_1");
  EXPECT_TRUE(has_states_between(states));
}

TEST(States, have_the_force_that_their_stage_gives_and_not_how_V_wavers_at_its_end)
{
  record::RunRecord run = lived_pipe();
  run.settings.stage[1].vertical_force = run.settings.stage[2].vertical_force = 800;
  for (Index k = 0; k < run.history.rows(); ++k)
    if (run.history.stage[k] == "unload" || run.history.stage[k] == "lay_2") run.history.values[4][k] *= 1.1;
  const States states = states_of(run);
  EXPECT_EQ(find_state(states, "laid")->V, 800);
  EXPECT_EQ(find_state(states, "operation")->V, 300);
  EXPECT_TRUE(find_state(states, "operation")->V_given);
}

TEST(States, have_the_force_of_the_soil_where_their_stage_ended_before_it_came_to_its_own)
{
  record::RunRecord run = lived_pipe();
  run.settings.stage[3].force = 100;
  const State operation = *find_state(states_of(run), "operation");
  EXPECT_NEAR(operation.V, 300, 1e-9);
  EXPECT_FALSE(operation.V_given);
  EXPECT_NE(operation.origin.find("has not reached its force of 100 N/m"), std::string::npos) << operation.origin;
  run.settings.stage[4].vertical_force = 310;
  EXPECT_EQ(find_state(states_of(run), "operation")->origin, "end of stage unload, before sweep_1") << "under the force of the drag";
  EXPECT_EQ(find_state(states_of(run), "operation")->V, 310);
  run.settings.stage[4].vertical_force = 500;
  EXPECT_NEAR(find_state(states_of(run), "operation")->V, 300, 1e-9) << "to which the drag did not come either";
}

TEST(States, of_a_push_and_a_drag_tell_no_more_than_these)
{
  const record::RunRecord run = MadeRun{}.record();
  EXPECT_FALSE(has_states_between(states_of(run)));
  EXPECT_EQ(run.quantity("operation.w"), nullptr);
}

TEST(States, are_those_whose_roles_are_said)
{
  record::RunRecord run = lived_pipe();
  run.settings.stage[3].role = settings::StageRole::flooded;
  const States states = states_of(run);
  ASSERT_NE(find_state(states, "flooded"), nullptr);
  EXPECT_EQ(find_state(states, "flooded")->stage, "unload");
  EXPECT_EQ(find_state(states, "laid"), nullptr) << "where a role is said none is guessed";
  run.settings.stage[3].role = settings::StageRole::automatic;
  run.settings.stage[5].role = settings::StageRole::breakout;
  EXPECT_EQ(find_state(states_of(run), "operation")->origin, "end of stage sweep_1, before sweep_2");
}

TEST(Results, of_states_and_of_the_main_drag_are_told)
{
  const record::RunRecord run = lived_pipe();
  EXPECT_NEAR(run.quantity("operation.w")->value, 0.29 * D, 1e-9);
  EXPECT_NEAR(run.quantity("laid.V")->value, 800, 1e-9);
  EXPECT_EQ(run.quantity("operation.w")->of, "operation");
  const Results results = DrivenRun(run).results();
  EXPECT_EQ(results.main_drag().stage, "sweep_1");
  EXPECT_EQ(results.prefix_of(results.main_drag()), "sweep_1.");
  ASSERT_EQ(results.states.size(), 3u) << "read back from the quantities";
}

/// A pipe that is pushed to 0.2 D, unloaded to 40 N/m, rests, and is lifted by 0.1 D, where the soil pulls it down.
record::RunRecord lifted(Real V_at_the_end = -60)
{
  MadeRun made;
  made.dragged = 0;
  made.pushed_to = 0.2 * D;
  record::RunRecord run = made.record();
  const auto add = [&](const char* name, settings::StageKind kind, Real w, Real V) {
    if (run.settings.stage.back().name != name) {
      run.settings.stage.push_back(MadeRun::stage_of(name, kind));
      run.settings.stage.back().velocity.reset();
    }
    const Real row[] = {static_cast<Real>(run.history.rows()), 0, w, 0, V};
    for (int k = 0; k < 5; ++k) run.history.values[k].push_back(row[k]);
    run.history.stage.emplace_back(name);
  };
  for (int k = 0; k < 50; ++k) add("unload", settings::StageKind::push, 0.2 * D, 40);
  run.settings.stage.back().force = 40;
  for (int k = 0; k < 50; ++k) add("rest", settings::StageKind::free, 0.2 * D, 40);
  for (int k = 1; k <= 50; ++k) add("lift", settings::StageKind::push, (0.2 - 0.002 * k) * D, std::lerp(40, V_at_the_end, k / 50.));
  run.settings.stage.back().velocity = -0.1;
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(States, of_operation_is_that_before_a_lift)
{
  const State operation = *find_state(states_of(lifted()), "operation");
  EXPECT_EQ(operation.origin, "end of stage rest, before lift");
  EXPECT_NEAR(operation.w, 0.2 * D, 1e-9);
  EXPECT_NEAR(operation.V, 40, 1e-9);
  EXPECT_GT(lifted().quantity("operation.V")->value, 0);
  EXPECT_EQ(find_state(states_of(lifted(0)), "operation")->stage, "rest") << "it leaves the soil without being pulled";
}

TEST(States, of_operation_may_be_after_an_unloading_by_velocity)
{
  EXPECT_EQ(find_state(states_of(lifted(20)), "operation")->stage, "lift") << "the soil still carries it";
}

TEST(States, of_operation_is_where_a_pipe_that_was_lifted_is_laid_again)
{
  record::RunRecord run = lifted();
  run.settings.stage.push_back(MadeRun::stage_of("again", settings::StageKind::push));
  run.settings.stage.back().velocity.reset();
  run.settings.stage.back().force = 30;
  for (int k = 1; k <= 50; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), 0, 0.15 * D, 0, 30};
    for (int c = 0; c < 5; ++c) run.history.values[c].push_back(row[c]);
    run.history.stage.emplace_back("again");
  }
  EXPECT_EQ(find_state(states_of(run), "operation")->stage, "again");
}

/// The area of an excavation in stage "rest", this far below the bottom of the pipe, over D.
record::RunRecord dug(Real below)
{
  record::RunRecord run = lifted();
  bodies::ExcavationSettings trench;
  trench.name = "trench";
  trench.stage = "rest";
  const Real top = -(0.2 + below) * D;
  trench.area.x = {-D, D, D, -D};
  trench.area.y = {top - D, top - D, top, top};
  run.settings.body.front().second.excavation.push_back(trench);
  return run;
}

TEST(SoilWork, at_the_body_ends_what_was_found_before_it)
{
  const record::RunRecord run = dug(1.9);
  const std::optional<SoilWork> work = last_soil_work(run, run.history.rows() - 1);
  ASSERT_TRUE(work);
  EXPECT_EQ(run.history.stage[work->row], "rest");
  EXPECT_NE(run.history.stage[work->row - 1], "rest");
  EXPECT_EQ(work->words, "excavation trench, in stage \"rest\"");
  EXPECT_FALSE(last_soil_work(run, work->row - 1)) << "not yet";
  EXPECT_FALSE(last_soil_work(dug(2.1), run.history.rows() - 1)) << "more than 2 D away";
}

TEST(Resistance, of_a_sweep_that_ends_at_a_berm_is_its_plateau_and_that_of_the_berm)
{
  const record::RunRecord run = lived_pipe();
  EXPECT_NEAR(run.quantity("sweep_1.H_residual")->value, 100, 1e-6);
  EXPECT_EQ(run.quantity("sweep_1.H_berm"), nullptr);
  EXPECT_NEAR(run.quantity("sweep_2.H_residual")->value, 80, 1e-6);
  EXPECT_NEAR(run.quantity("sweep_2.H_berm")->value, 160, 1e-6);
  EXPECT_EQ(run.quantity("sweep_2.H_breakout"), nullptr);
}

}  // namespace
}  // namespace berm::driven::this_file
