// SPDX-License-Identifier: BSD-3-Clause
#include "structures/anchor/anchor.hpp"
#include "structures/structures.hpp"

#include "samples/made_run.hpp"
#include "samples/names_before_a_run.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/base/kind.hpp"

#include <gtest/gtest.h>

namespace berm::anchor::this_file {
namespace {

/// Dragged 10 D, 0.2 m: it sinks from 2 mm with a slope of a half for 0.1 m and then stays, under H that grows to 3 kN/m and stays.
record::RunRecord dragged()
{
  MadeRun made;
  made.method = settings::Method::fem;
  made.dragged = 0.2;
  made.sunk = [](Real u) { return std::min(u, 0.1) / 2; };
  made.H = [](Real u) { return 3e4 * std::min(u, 0.1); };
  record::RunRecord run = made.record();
  run.settings.rigid[0].second.structure = "anchor";
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(Anchor, is_named)
{
  const record::RunRecord run = dragged();
  EXPECT_STREQ(structures::structure_of(run.settings).word, "anchor");
  EXPECT_STRNE(structures::structure_of(MadeRun{}.settings()).word, "anchor");
}

TEST(Anchor, tells_depth_and_tow_force_over_travel)
{
  const record::RunRecord run = dragged();
  const auto value = [&](const char* name) { return base::quantity_value(run, name); };
  EXPECT_NEAR(value("tow_travel"), 0.2, 1e-9);
  EXPECT_NEAR(value("tow_depth_begin"), 0.002, 1e-9);
  EXPECT_NEAR(value("tow_depth_end"), 0.052, 1e-9);
  EXPECT_NEAR(value("tow_depth_max"), 0.052, 1e-9);
  EXPECT_NEAR(value("u_at_tow_depth_max"), 0.1, 5e-5);  // rows are 0.04 mm apart
  EXPECT_NEAR(value("tow_force_max"), 3000, 1e-6);
  EXPECT_NEAR(value("tow_force_end"), 3000, 1e-6);
  EXPECT_NEAR(value("tow_V_end"), 800, 1e-6);
  EXPECT_NEAR(value("tow_depth_change"), 0, 1e-9);
  EXPECT_NEAR(value("tow_work"), 3000 * 0.05 + 3000 * 0.1, 0.1);
}

TEST(Anchor, knows_the_names_of_its_results_before_a_run)
{
  const record::RunRecord run = dragged();
  EXPECT_EQ(surprises_of(run), std::vector<std::string>{});
  EXPECT_FALSE(knows(run.settings, "tow_force"));
}

TEST(Anchor, that_was_not_dragged_has_no_tow)
{
  MadeRun made;
  made.dragged = 0;
  const record::RunRecord run = made.record();
  EXPECT_TRUE(tow_path(run).travel.empty());
  base::AnswerList list(2);
  list.add(tow_answers, tow_results(tow_path(run), base::body_scale(run)));
  EXPECT_TRUE(list.list().empty());
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const std::string words = structures::structure_of(run.settings).in_words(run, shown);
  EXPECT_EQ(words.find("ragged"), std::string::npos) << words;
  EXPECT_NE(words.find("V = "), std::string::npos) << words;
}

}  // namespace
}  // namespace berm::anchor::this_file
