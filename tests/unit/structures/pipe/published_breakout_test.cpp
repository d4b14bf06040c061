// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/published.hpp"

#include "samples/made_run.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

using Kind = ComparedState::Kind;

/// The first state of a kind.
const ComparedState* state_of(const PublishedValues& values, Kind kind)
{
  const auto found =
      std::find_if(values.states.begin(), values.states.end(), [&](const ComparedState& state) { return state.kind == kind; });
  return found == values.states.end() ? nullptr : &*found;
}

/// The first comparison with a source whose name begins so and whose remark holds `about`.
const Comparison* by(const ComparedState* state, const std::string& work, const std::string& about)
{
  if (state == nullptr) return nullptr;
  for (const Comparison& c : state->comparisons)
    if (std::string(c.published.source.work).starts_with(work) && c.about.find(about) != std::string::npos) return &c;
  return nullptr;
}

/// A drag of 3 D in clay under 10 N/m that breaks out at 0.2 D with 40 N/m and has come to 20 N/m at 1 D.
MadeRun long_drag_in_clay()
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  made.dragged = 0.06;
  made.held_V = 10;
  made.sunk = [](Real) { return 0.; };
  made.H = [](Real u) { return u < 0.004 ? 1e4 * u : std::max(20., 40 - 1250 * (u - 0.004)); };
  return made;
}

TEST(published_breakout, breakout_in_clay_stands_beside_both_undrained_models_and_the_displacements_of_the_tables)
{
  const PublishedValues values = published_beside(driven::DrivenRun(long_drag_in_clay().record()));
  const ComparedState* peak = state_of(values, Kind::peak);
  ASSERT_NE(peak, nullptr);
  EXPECT_EQ(peak->point, ComparedState::Point::peak);
  // Smooth, w = 0.1 D = 2 mm, s_u = 1 kPa, gamma' = 430 kN/m3: w (c s_u + gamma' w/2) = 0.002 (1000 c + 430).
  for (const auto& [estimate, c] : {std::pair{"LE", 2.}, std::pair{"BE", 2.25}, std::pair{"HE", 2.5}}) {
    const Comparison* model = by(peak, "DNVGL-RP-F114", estimate);
    ASSERT_NE(model, nullptr);
    EXPECT_NE(model->about.find("without suction"), std::string::npos);
    EXPECT_NEAR(model->published.value, 0.002 * (1000 * c + 430), 1e-9);
    EXPECT_NEAR(model->berm, 40, 1);
  }
  // 20 [1.7 x 0.1^0.61 + 0.23 x 0.5^0.83] + 0.6 x 430e3 x 4e-6.
  EXPECT_NEAR(by(peak, "DNV-RP-F114 (2021)", "model 2")->published.value, 20 * (1.7 * 0.245471 + 0.23 * 0.562529) + 1.032, 1e-3);
  const Comparison* displacement = by(state_of(values, Kind::breakout), "DNVGL-RP-F114", "BE");
  ASSERT_NE(displacement, nullptr);
  EXPECT_NEAR(displacement->berm, 0.004, 2e-4) << "rounded by averaging over 0.01 D to either side";
  EXPECT_NEAR(displacement->published.value, 0.02 * 0.045, 1e-9);
}

TEST(published_breakout, a_drag_too_short_for_any_other_comparison_may_have_a_breakout)
{
  MadeRun made = long_drag_in_clay();
  made.dragged = 0.0018;  // 0.09 D
  made.H = [](Real u) { return u < 4e-4 ? 1e5 * u : std::max(30., 40 - 25e3 * (u - 4e-4)); };
  made.method = settings::Method::fem;  // without noise, which would take 0.1 D to be told from a peak
  made.first_w = 0.002;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const ComparedState* peak = state_of(values, Kind::peak);
  ASSERT_NE(peak, nullptr);
  EXPECT_NE(by(peak, "DNVGL-RP-F114", "LE"), nullptr);
  EXPECT_EQ(state_of(values, Kind::drag), nullptr);
}

TEST(published_breakout, the_clay_behind_a_pipe_pulls_where_the_contact_carries_tension)
{
  MadeRun made = long_drag_in_clay();
  made.contact.tension = std::numeric_limits<Real>::infinity();
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const ComparedState* peak = state_of(values, Kind::peak);
  ASSERT_NE(peak, nullptr);
  const Comparison* model = by(peak, "DNVGL-RP-F114", "with suction behind the pipe, LE");
  ASSERT_NE(model, nullptr);
  EXPECT_NEAR(model->published.value, 0.002 * 4 * 1000, 1e-9);
}

TEST(published_breakout, the_end_of_a_long_drag_stands_beside_the_residual_and_the_way_to_it)
{
  const PublishedValues values = published_beside(driven::DrivenRun(long_drag_in_clay().record()));
  const ComparedState* end = state_of(values, Kind::end_of_drag);
  ASSERT_NE(end, nullptr);
  const Comparison *residual = by(end, "DNV-RP-F114", "residual, BE"), *way = by(end, "DNVGL-RP-F114", "HE");
  ASSERT_NE(residual, nullptr);
  ASSERT_NE(way, nullptr);
  EXPECT_NEAR(residual->published.value, 10 * (0.32 + 0.8 * 0.158489), 1e-4);
  EXPECT_EQ(way->quantity, "u to the residual");
  EXPECT_NEAR(way->published.value, 0.056, 1e-12);
  EXPECT_NEAR(way->berm, 0.0192, 3e-4) << "H is 21 N/m, 5 % above the residual";
  // In sand the residual is as breakout at the embedment that is left.
  MadeRun sand;
  sand.dragged = 0.06;
  sand.sunk = [](Real) { return 0.; };
  const PublishedValues of_sand = published_beside(driven::DrivenRun(sand.record()));
  const ComparedState* its_end = state_of(of_sand, Kind::end_of_drag);
  ASSERT_NE(its_end, nullptr);
  const Comparison* again = by(its_end, "DNVGL-RP-F114", "residual");
  ASSERT_NE(again, nullptr);
  // Fp = 2.31143 x 430e3 x 0.002^2/2 = 1.98783 N/m.
  EXPECT_NEAR(again->published.value, 1.98783 + 0.431358 * (800 - 0.431358 * 1.98783), 0.01);
  EXPECT_TRUE(std::isnan(by(its_end, "DNVGL-RP-F114", "LE")->berm)) << "H grows to the end";
}

TEST(published_breakout, a_force_that_the_case_prescribes_is_compared_with_no_resistance)
{
  record::RunRecord run = long_drag_in_clay().record();
  for (settings::StageSettings& stage : run.settings.stage)
    if (stage.kind == settings::StageKind::drag) stage.velocity.reset(), stage.force = 20;
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const PublishedValues values = published_beside(driven::DrivenRun(run));
  for (const Kind kind : {Kind::peak, Kind::breakout, Kind::end_of_drag}) EXPECT_EQ(state_of(values, kind), nullptr);
}

}  // namespace
}  // namespace berm::pipe::this_file
