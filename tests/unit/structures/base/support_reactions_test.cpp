// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/support_reactions.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

/// A made run whose base gets 10 t and 100 + t at the time t, N/m.
record::RunRecord run_on_base()
{
  record::RunRecord run = MadeRun{}.record();
  run.settings.support = {{"sea_base", {"bottom", {"x", "y"}}}};
  run.settings.output.support_reactions = true;
  const std::vector<Real> time = run.history["time_s"];
  for (const char* name : {"sea_base_Fx_N_m", "sea_base_Fy_N_m"}) run.history.columns.push_back({name, "", "N/m", "", "sea_base"});
  run.history.values.emplace_back();
  run.history.values.emplace_back();
  for (const Real t : time) {
    run.history.values[run.history.values.size() - 2].push_back(10 * t);
    run.history.values.back().push_back(100 + t);
  }
  return run;
}

TEST(SupportReactions, are_means_over_the_last_twentieth_of_each_stage)
{
  const record::RunRecord run = run_on_base();
  const std::vector<SupportReaction> found = support_reactions_of(run);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].stage, "push");
  EXPECT_EQ(found[1].stage, "drag");
  EXPECT_EQ(found[0].support, "sea_base");
  // The push has the rows 1 to 50, a second apart: those from 50 - 49 / 20 on are three.
  ASSERT_EQ(found[0].force.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].force[0], 490);
  EXPECT_DOUBLE_EQ(found[0].force[1], 149);
}

TEST(SupportReactions, have_names_that_are_known_before_the_run)
{
  const record::RunRecord run = run_on_base();
  std::vector<std::string> names;
  for (const run_folder::Quantity& q : support_quantities(run)) names.push_back(q.name);
  EXPECT_EQ(names, (std::vector<std::string>{"sea_base_Fx_of_push", "sea_base_Fy_of_push", "sea_base_Fx_of_drag", "sea_base_Fy_of_drag"}));
  EXPECT_EQ(names, support_quantity_names(run.settings));
  for (const std::string& name : names) {
    const std::vector<std::string> known = structures::structure_of(run.settings).quantity_names(run.settings);
    EXPECT_NE(std::find(known.begin(), known.end(), name), known.end()) << name;
  }
}

TEST(SupportReactions, are_none_where_they_are_not_asked_for)
{
  EXPECT_TRUE(support_quantities(MadeRun{}.record()).empty());
  EXPECT_TRUE(support_quantity_names(MadeRun{}.settings()).empty());
}

}  // namespace
}  // namespace berm::base::this_file
