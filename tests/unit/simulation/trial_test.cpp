// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/trial.hpp"

#include <gtest/gtest.h>

namespace berm::simulation::this_file {
namespace {

Real check_of(const Trial& trial, const std::string& name)
{
  for (const auto& [key, value] : trial.checks())
    if (key == name) return std::visit([](auto number) -> Real { return number; }, value);
  return nan;
}

TEST(Trial, fails_where_the_soil_moves_by_more_than_the_limit_in_a_stage_that_moves_no_body)
{
  Trial trial(0.1);
  trial.begin_stage(false);
  trial.note(0.5);
  EXPECT_FALSE(trial.failed());
  trial.begin_stage(true);
  trial.note(0.1);
  EXPECT_FALSE(trial.failed());
  trial.note(0.11);
  EXPECT_TRUE(trial.failed());
  trial.note(0.05);
  EXPECT_TRUE(trial.failed()) << "soil that comes back has failed all the same";
  EXPECT_EQ(check_of(trial, "soil_failed"), 1);
  EXPECT_EQ(check_of(trial, "soil_movement_limit_m"), 0.1);
}

TEST(Trial, stands_where_it_has_not_failed_and_rests_at_the_end)
{
  Trial trial(0.1);
  trial.note(0.01);
  EXPECT_EQ(check_of(trial, "soil_at_rest"), 0);
  trial.end(true);
  EXPECT_EQ(check_of(trial, "soil_at_rest"), 1);
  EXPECT_EQ(check_of(trial, "soil_failed"), 0);
  EXPECT_NE(trial.words(1.3).find("stands"), std::string::npos);
}

TEST(Trial, is_undecided_where_it_neither_rests_nor_has_failed)
{
  Trial trial(0.1);
  trial.note(0.01);
  trial.end(false);
  EXPECT_EQ(check_of(trial, "soil_at_rest"), 0);
  EXPECT_EQ(check_of(trial, "soil_failed"), 0);
  EXPECT_NE(trial.words(1.3).find("more time"), std::string::npos);
}

TEST(Trial, fails_without_an_equilibrium)
{
  Trial trial(0.1);
  trial.note_no_equilibrium();
  trial.end(false);
  EXPECT_TRUE(trial.failed());
}

/// A trial whose movement is 1 mm (1 - exp(-10 t)) and v t until t = 1 s.
Trial flowing(Real v)
{
  Trial trial(0.1);
  for (int k = 0; k <= 10; ++k) trial.note(k / 10., 1e-3 * (1 - std::exp(-k)) + v * k / 10.);
  return trial;
}

TEST(Trial, flows_on_where_a_tenth_of_the_movement_comes_in_the_last_half_of_the_time)
{
  EXPECT_FALSE(flowing(0).flows_on());
  EXPECT_FALSE(flowing(0.2e-3).flows_on()) << "0.107 mm of 1.2 mm";
  EXPECT_TRUE(flowing(0.3e-3).flows_on()) << "0.157 mm of 1.3 mm";
  EXPECT_TRUE(flowing(1).flows_on());
}

TEST(Trial, takes_no_flow_from_what_is_round_off_beside_the_limit)
{
  Trial trial(0.1);
  trial.note(0, 0);
  trial.note(1, 1e-9);
  EXPECT_FALSE(trial.flows_on());
  EXPECT_FALSE(Trial(0.1).flows_on());
}

TEST(Trial, fails_by_flow_only_where_soil_yields)
{
  Trial yields = flowing(1e-3), drains = flowing(1e-3), elastic = flowing(1e-3), rests = flowing(0);
  yields.end_flow(1e-3);
  EXPECT_TRUE(yields.failed());
  drains.end_flow(1e-7);
  EXPECT_FALSE(drains.failed());
  EXPECT_EQ(check_of(drains, "soil_at_rest"), 0) << "undecided";
  elastic.end_flow(0);
  EXPECT_EQ(check_of(elastic, "soil_at_rest"), 1) << "soil that yields nowhere stands";
  rests.end_flow(0.1);
  EXPECT_FALSE(rests.failed());
  EXPECT_EQ(check_of(rests, "soil_at_rest"), 1);
}

TEST(Trial, tells_the_time_factor_of_soil_whose_water_flows)
{
  EXPECT_EQ(check_of(Trial(0.1, 0.18), "time_factor_of_last_stage"), 0.18);
  EXPECT_TRUE(std::isnan(check_of(Trial(0.1), "time_factor_of_last_stage")));
}

TEST(WindowMeans, tell_the_drift_of_a_number_that_swings)
{
  WindowMeans means(1);
  for (int k = 0; k <= 3010; ++k) {
    const Real t = k / 1000.;
    means.note(t, 5 * std::sin(2 * pi * t) + 0.2 * t);
    if (k < 1990) {
      EXPECT_EQ(means.drift(), infinity);
    }
  }
  EXPECT_NEAR(means.drift(), 0.2, 0.02) << "windows are whole to a thousandth, a swing of 5 leaves 5 / 1000 of itself";
  means.note(0, 1);
  EXPECT_EQ(means.drift(), infinity) << "another stage begins";
}

}  // namespace
}  // namespace berm::simulation::this_file
