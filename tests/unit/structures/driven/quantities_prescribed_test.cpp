// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/quantities.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

using settings::StageKind;
using settings::StageSettings;

/// A run that pushes to 2 mm, where V = 800 N/m, and drags by 10 mm, as these settings of its stages have it.
record::RunRecord run_with(const std::function<void(StageSettings& push, StageSettings& drag)>& settings)
{
  record::RunRecord run = MadeRun{}.record();
  settings(run.settings.stage[0], run.settings.stage[1]);
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

bool prescribes(const record::RunRecord& run, const std::string& name)
{
  const run_folder::Quantity* quantity = run.quantity(name);
  EXPECT_NE(quantity, nullptr) << name;
  return quantity != nullptr && quantity->kind == run_folder::QuantityKind::prescribed;
}

TEST(Prescribed, is_the_limit_that_ends_a_push)
{
  const record::RunRecord by_w = run_with([](auto& push, auto&) { push.until.embedment = 0.0020005; });
  EXPECT_TRUE(prescribes(by_w, "w_end_of_push")) << "met after the step";
  EXPECT_FALSE(prescribes(by_w, "V_end_of_push"));
  EXPECT_FALSE(prescribes(run_with([](auto& push, auto&) { push.until.embedment = 0.003; }), "w_end_of_push"))
      << "another limit came first";
  const record::RunRecord by_V = run_with([](auto& push, auto&) { push.until.force = 800; });
  EXPECT_TRUE(prescribes(by_V, "V_end_of_push"));
  EXPECT_FALSE(prescribes(by_V, "w_end_of_push"));
}

// A row of particles that comes into contact may end a short push far above its mean.
TEST(Prescribed, is_the_limit_of_force_at_the_end_of_a_push_and_neither_its_mean_nor_its_last_row)
{
  const auto end_of_push = [](Real limit) {
    MadeRun made;
    made.V = [](Real w) { return w < 0.00197 ? 250. : 810.; };
    record::RunRecord run = made.record();
    run.settings.stage[0].until.force = limit;
    return results_from(run.history, base::body_scale(run), stages_of(run.settings)).push_end->V;
  };
  EXPECT_EQ(end_of_push(800), 800);
  EXPECT_LT(end_of_push(900), 700) << "another limit came first";
}

TEST(Prescribed, is_one_of_two_limits)
{
  const auto both = [](Real w) {
    return run_with([w](auto& push, auto&) {
      push.until.embedment = w;
      push.until.force = 5000;
    });
  };
  EXPECT_FALSE(prescribes(both(0.002), "V_end_of_push")) << "w came first";
  EXPECT_TRUE(prescribes(both(0.004), "V_end_of_push"));
}

TEST(Prescribed, is_the_force_that_drives)
{
  EXPECT_TRUE(prescribes(run_with([](auto& push, auto&) { push.force = 300; }), "V_end_of_push"));
  const record::RunRecord dragged = run_with([](auto&, auto& drag) { drag.vertical_force = 300; });
  EXPECT_TRUE(prescribes(dragged, "V_end_of_drag"));
  EXPECT_TRUE(prescribes(dragged, "V_in_drag"));
  EXPECT_FALSE(prescribes(dragged, "w_end_of_drag"));
  const record::RunRecord by_H = run_with([](auto&, auto& drag) {
    drag.velocity.reset();
    drag.force = 300;
  });
  EXPECT_TRUE(prescribes(by_H, "H_end_of_drag"));
  EXPECT_FALSE(prescribes(by_H, "u_end"));
}

TEST(Prescribed, is_the_travel_of_a_drag_and_its_level_where_it_is_fixed)
{
  const record::RunRecord run = run_with([](auto&, auto& drag) {
    drag.until.displacement = 0.01;
    drag.vertical = settings::Vertical::fixed;
  });
  for (const char* name : {"w_end_of_drag", "w_at_u_0.1D", "u_end_of_drag"}) EXPECT_TRUE(prescribes(run, name)) << name;
  for (const char* name : {"H_end_of_drag", "H_at_u_0.1D", "H_max"}) EXPECT_FALSE(prescribes(run, name)) << name;
}

TEST(Quantities, say_what_they_are_for_and_of_which_travel)
{
  const record::RunRecord run = run_with([](auto&, auto&) {});
  using enum run_folder::QuantityKind;
  EXPECT_EQ(run.quantity("H_max")->kind, answer);
  EXPECT_EQ(run.quantity("H_max")->of, "drag");
  EXPECT_EQ(run.quantity("V_end_of_push")->of, "push");
  EXPECT_EQ(run.quantity("H_max_over_gammaD2")->kind, ratio);
  EXPECT_EQ(run.quantity("V_rms_error_in_drag")->kind, quality);
}

}  // namespace
}  // namespace berm::driven::this_file
