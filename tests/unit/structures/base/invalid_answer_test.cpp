// SPDX-License-Identifier: BSD-3-Clause
// What spoils the answer of a run, and that nothing else does.
#include "structures/base/invalid_answer.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

record::RunRecord run_with(const std::string& check, Real value)
{
  record::RunRecord run = MadeRun().record();
  run.summary.emplace();
  run.summary->checks = {{"energy_error", 0.01}, {"momentum_error", 1e-12}, {"mass_at_max_volume", 0.001}};
  run.summary->checks[check] = value;
  return run;
}

bool says(const std::vector<std::string>& invalid, const std::string& words)
{
  return invalid.size() == 1 && invalid.front().find(words) != std::string::npos;
}

TEST(InvalidAnswer, sound_runs_are_not)
{
  EXPECT_TRUE(invalid_because(run_with("energy_error", 0.049)).empty());
  EXPECT_TRUE(invalid_because(MadeRun().record()).empty()) << "without a summary";
  EXPECT_STREQ(invalid_mark({}), "");
}

TEST(InvalidAnswer, by_energy_that_does_not_balance_from_where_the_page_calls_it_bad)
{
  EXPECT_TRUE(says(invalid_because(run_with("energy_error", 0.051)), "of the work is not balanced by energy"));
  EXPECT_TRUE(says(invalid_because(run_with("momentum_error", 1e-3)), "momentum"));
}

TEST(InvalidAnswer, by_soil_at_its_largest_volume)
{
  EXPECT_TRUE(says(invalid_because(run_with("mass_at_max_volume", 0.02)), "largest volume"));
  EXPECT_TRUE(invalid_because(run_with("mass_at_min_volume", 0.02)).empty());
}

TEST(InvalidAnswer, by_forces_that_are_no_numbers)
{
  MadeRun made;
  made.V = [](Real w) { return w > 0.001 ? nan : 1e5 * w; };
  EXPECT_TRUE(says(invalid_because(made.record()), "V is not a number from t = "));
}

TEST(InvalidAnswer, by_a_body_that_left_the_soil_and_not_by_one_that_comes_down_on_it)
{
  MadeRun made;
  made.held_V = 0;
  made.H = [](Real u) { return u < 0.005 ? 100 : 0; };
  EXPECT_TRUE(says(invalid_because(made.record()), "at the end of stage \"drag\" the body no longer touches soil"));
  made.H = [](Real u) { return u < 0.009 ? 0 : 100; };
  EXPECT_TRUE(invalid_because(made.record()).empty()) << "it touches soil at the end";
  MadeRun falling;
  falling.dragged = 0;
  falling.V = [](Real) { return 0; };
  EXPECT_TRUE(invalid_because(falling.record()).empty()) << "it never touched any";
}

TEST(InvalidAnswer, not_by_a_gate_that_is_drawn_away_from_the_soil_that_presses_on_it)
{
  MadeRun made;
  made.held_V = 0;
  made.H = [](Real u) { return u < 0.005 ? -100 : 0; };
  EXPECT_TRUE(invalid_because(made.record()).empty());
}

}  // namespace
}  // namespace berm::base::this_file
