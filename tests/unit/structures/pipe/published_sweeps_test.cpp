// SPDX-License-Identifier: BSD-3-Clause
// What stands beside the end of long drags in clay.
#include "structures/pipe/published.hpp"

#include "samples/made_run.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

/// Dragged 1.2 D in clay of 1 kPa, where H = 3e4 u and w = 0.1 D + u/20; and dragged back 1.2 D once more, where H is half of that.
record::RunRecord swept_twice(Real dragged = 0.024)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  made.dragged = dragged;
  made.sunk = [](Real u) { return u / 20; };
  record::RunRecord run = made.record();
  settings::StageSettings back = MadeRun::stage_of("back", settings::StageKind::drag);
  back.velocity = -0.1;
  run.settings.stage.push_back(back);
  const Real step = 0.002 * made.D, deepest = made.pushed_to + dragged / 20;
  for (int k = 1; k * step <= dragged + step / 2; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), dragged - k * step, deepest, -1.5e4 * k * step, made.held_V};
    for (int column = 0; column < 5; ++column) run.history.values[column].push_back(row[column]);
    run.history.stage.push_back("back");
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

std::vector<const ComparedState*> ends(const PublishedValues& values)
{
  std::vector<const ComparedState*> found;
  for (const ComparedState& state : values.states)
    if (state.kind == ComparedState::Kind::end_of_drag) found.push_back(&state);
  return found;
}

TEST(published_sweeps, the_first_long_drag_stands_beside_residuals_and_the_next_between_berms)
{
  const PublishedValues values = published_beside(driven::DrivenRun(swept_twice()));
  const auto found = ends(values);
  ASSERT_EQ(found.size(), 2u);
  const ComparedState &first = *found[0], &back = *found[1];
  EXPECT_EQ(first.stage, "drag");
  ASSERT_EQ(first.comparisons.size(), 7u) << "White and Cheuk, three estimates, and three of the way to it";
  // s_u/(2 gamma' D) = 1000/17200.
  EXPECT_NEAR(first.comparisons[0].published.value, 800 * (1 - 0.65 * (1 - std::exp(-1000 / 17200.))), 0.5);
  EXPECT_EQ(first.comparisons[0].quantity, "residual H");
  for (int k = 0; k < 4; ++k) {
    EXPECT_TRUE(std::isnan(first.comparisons[k].berm)) << "H grows to the end: there is no residual";
    EXPECT_TRUE(std::isnan(first.comparisons[k].ratio()));
  }
  EXPECT_EQ(first.comparisons[1].about, "residual, LE, low estimate");
  EXPECT_LT(first.comparisons[1].published.value, first.comparisons[2].published.value);
  EXPECT_LT(first.comparisons[2].published.value, first.comparisons[3].published.value);
  EXPECT_EQ(first.comparisons[4].quantity, "u to the residual");
  EXPECT_EQ(back.stage, "back");
  ASSERT_EQ(back.comparisons.size(), 4u);
  EXPECT_NEAR(back.comparisons[0].berm, 1.5e4 * 0.012, 2) << "H in the middle of the way";
  EXPECT_NEAR(back.comparisons[0].published.value, 0.25 * 800, 2);
  EXPECT_EQ(back.comparisons[2].quantity, "H against a berm");
  EXPECT_NEAR(back.comparisons[2].berm, 342, 3) << "the mean over the last 0.12 D of 1.5e4 u";
  EXPECT_NEAR(back.comparisons[2].published.value, 0.9 * 0.16 * 20, 0.1) << "w = 0.1 D + 0.06 D";
}

TEST(published_sweeps, residual_formulas_stand_beside_the_plateau_and_never_beside_the_berm)
{
  // 200 N/m from 0.2 D on, from 1.2 D on up to 350 N/m at 1.4 D, to 1.6 D.
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  made.dragged = 1.6 * made.D;
  made.sunk = [](Real u) { return u / 20; };
  made.H = [](Real u) {
    const Real x = u / 0.02;
    return x < 0.2 ? 1000 * x : x < 1.2 ? 200 : x < 1.4 ? 200 + 750 * (x - 1.2) : 350;
  };
  const PublishedValues in_clay = published_beside(driven::DrivenRun(made.record()));
  const auto found = ends(in_clay);
  ASSERT_EQ(found.size(), 1u);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(found[0]->comparisons[k].berm, 200, 2) << k;

  made.law = MadeRun::sand_law();
  const PublishedValues in_sand = published_beside(driven::DrivenRun(made.record()));
  ASSERT_EQ(ends(in_sand).size(), 1u);
  const Comparison& sand = ends(in_sand)[0]->comparisons.at(0);
  EXPECT_NEAR(sand.berm, 200, 2);
  EXPECT_EQ(sand.about.find("residual, as breakout at w = 0.1"), 0u) << "where the plateau is, not at the end: " << sand.about;
}

TEST(published_sweeps, a_drag_of_less_than_a_diameter_has_no_residual)
{
  EXPECT_TRUE(ends(published_beside(driven::DrivenRun(swept_twice(0.018)))).empty());
}

}  // namespace
}  // namespace berm::pipe::this_file
