// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/results/quantities.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

using problem::StageKind;
using problem::StageSettings;

/// A run that pushes to 2 mm and drags by 10 mm, then drags on in a stage `back`.
record::RunRecord run_with(const std::function<void(StageSettings& push, StageSettings& drag)>& settings)
{
  record::RunRecord run = MadeRun{}.record();
  settings(run.settings.stage[0], run.settings.stage[1]);
  run.settings.stage.push_back(MadeRun::stage_of("back", StageKind::drag));
  run.settings.stage.back().until.displacement = 0.03;
  return run;
}

bool prescribes(const record::RunRecord& run, const std::string& name, Real value)
{
  return is_prescribed(run, {name, value, "", ""});
}

TEST(Prescribed, is_the_limit_that_ends_a_push)
{
  const record::RunRecord by_w = run_with([](auto& push, auto&) { push.until.embedment = 0.002; });
  EXPECT_TRUE(prescribes(by_w, "w_end_of_push", 0.0020005)) << "met after the step";
  EXPECT_TRUE(prescribes(by_w, "push.w_end", 0.0020005));
  EXPECT_FALSE(prescribes(by_w, "V_end_of_push", 800));
  EXPECT_FALSE(prescribes(by_w, "w_end_of_push", 0.0015)) << "another limit came first";
  const record::RunRecord by_V = run_with([](auto& push, auto&) { push.until.force = 800; });
  EXPECT_TRUE(prescribes(by_V, "V_end_of_push", 803));
  EXPECT_FALSE(prescribes(by_V, "w_end_of_push", 0.002));
}

TEST(Prescribed, is_one_of_two_limits)
{
  record::RunRecord run = run_with([](auto& push, auto&) {
    push.until.embedment = 0.002;
    push.until.force = 5000;
  });
  run.quantities = {{"w_end_of_push", 0.002, "m", ""}};
  EXPECT_FALSE(prescribes(run, "V_end_of_push", 800)) << "w came first";
  run.quantities[0].value = 0.001;
  EXPECT_TRUE(prescribes(run, "V_end_of_push", 5000));
}

TEST(Prescribed, is_the_force_that_drives)
{
  const record::RunRecord pushed = run_with([](auto& push, auto&) { push.force = 300; });
  EXPECT_TRUE(prescribes(pushed, "V_end_of_push", 300));
  const record::RunRecord dragged = run_with([](auto&, auto& drag) { drag.vertical_force = 300; });
  EXPECT_TRUE(prescribes(dragged, "V_end_of_drag", 300));
  EXPECT_TRUE(prescribes(dragged, "V_in_drag", 300));
  EXPECT_FALSE(prescribes(dragged, "w_end_of_drag", 0.004));
  EXPECT_FALSE(prescribes(dragged, "back.V_in_drag", 300)) << "of another drag";
}

TEST(Prescribed, is_the_travel_of_a_drag_and_its_level_where_it_is_fixed)
{
  const record::RunRecord run = run_with([](auto&, auto& drag) {
    drag.until.displacement = 0.01;
    drag.vertical = problem::Vertical::fixed;
  });
  for (const char* name : {"w_end_of_drag", "w_at_u_0.1D", "drag.w_at_u_0.1D"}) EXPECT_TRUE(prescribes(run, name, 0.002)) << name;
  EXPECT_TRUE(prescribes(run, "u_end_of_drag", 0.01));
  EXPECT_FALSE(prescribes(run, "back.w_at_u_0.1D", 0.002));
  EXPECT_FALSE(prescribes(run, "back.u_end_of_drag", 0.01));
  EXPECT_TRUE(prescribes(run, "back.u_end_of_drag", 0.03));
  for (const char* name : {"H_end_of_drag", "H_at_u_0.1D", "H_max"}) EXPECT_FALSE(prescribes(run, name, 300)) << name;
}

TEST(Prescribed, is_known_for_a_case_without_a_drag)
{
  record::RunRecord run = run_with([](auto& push, auto&) { push.force = 300; });
  run.settings.stage.resize(1);
  EXPECT_TRUE(prescribes(run, "V_end_of_push", 300));
  EXPECT_FALSE(prescribes(run, "w_end_of_drag", 0.002));
}

}  // namespace
}  // namespace berm::driven::this_file
