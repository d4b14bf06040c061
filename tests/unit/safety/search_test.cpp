// SPDX-License-Identifier: BSD-3-Clause
#include "safety/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace berm::safety::this_file {
namespace {

using Answer = std::function<TrialEnd(Real)>;

/// Soil that stands up to a factor, that included.
Answer soil_of(Real factor)
{
  return [factor](Real f) { return f <= factor ? TrialEnd::stands : TrialEnd::fails; };
}

/// Makes the trials that the search asks for until it is over; the rounds.
std::vector<std::vector<Real>> search(std::vector<Trial>& trials, const Answer& soil, const SearchSettings& settings)
{
  std::vector<std::vector<Real>> rounds;
  for (std::vector<Real> next; !(next = next_factors(trials, settings)).empty();) {
    rounds.push_back(next);
    for (const Real factor : next) trials.push_back({factor, soil(factor)});
    if (rounds.size() > 100) throw std::logic_error("the search does not end");
  }
  return rounds;
}

TEST(SafetySearch, ends_with_a_bracket_that_holds_the_factor_and_is_no_wider_than_the_tolerance)
{
  for (const int at_once : {1, 2, 3, 8})
    for (const Real factor : {1.0, 1.0049, 1.38, 1.7777, 1.9999})
      for (const Real tolerance : {0.001, 0.01, 0.3}) {
        std::vector<Trial> trials;
        const auto rounds = search(trials, soil_of(factor), {1, 2, tolerance, at_once});
        const Bracket bracket = bracket_of(trials);
        ASSERT_TRUE(bracket.stands && bracket.fails) << factor;
        EXPECT_LE(*bracket.stands, factor);
        EXPECT_GT(*bracket.fails, factor);
        EXPECT_LE(*bracket.fails - *bracket.stands, tolerance * (1 + 1e-9)) << factor << ' ' << at_once;
        for (const auto& round : rounds) EXPECT_LE(static_cast<int>(round.size()), at_once);
      }
}

TEST(SafetySearch, makes_no_trial_twice)
{
  std::vector<Trial> trials;
  search(trials, soil_of(1.38), {1, 2, 0.01, 3});
  std::vector<Real> factors;
  for (const Trial& trial : trials) factors.push_back(trial.factor);
  std::sort(factors.begin(), factors.end());
  EXPECT_EQ(std::adjacent_find(factors.begin(), factors.end()), factors.end());
}

TEST(SafetySearch, by_bisection_takes_as_many_trials_as_halves_make_the_tolerance)
{
  std::vector<Trial> trials;
  search(trials, soil_of(1.38), {1, 2, 0.01, 1});
  EXPECT_EQ(trials.size(), 2u + 7u) << "1 / 2^7 < 0.01";
}

TEST(SafetySearch, begins_between_low_and_high_with_as_many_trials_as_run_at_once)
{
  EXPECT_EQ(next_factors({}, {1, 2, 0.01, 1}), (std::vector<Real>{1}));
  EXPECT_EQ(next_factors({}, {1, 2, 0.01, 2}), (std::vector<Real>{1, 2}));
  EXPECT_EQ(next_factors({}, {1, 2, 0.01, 5}), (std::vector<Real>{1, 1.25, 1.5, 1.75, 2}));
  EXPECT_EQ(next_factors({{1, TrialEnd::stands}}, {1, 2, 0.01, 1}), (std::vector<Real>{2}));
}

TEST(SafetySearch, goes_below_low_where_the_soil_fails_as_it_is_and_above_high_where_it_stands)
{
  for (const Real factor : {0.31, 6.2})
    for (const int at_once : {1, 2, 4}) {
      std::vector<Trial> trials;
      search(trials, soil_of(factor), {1, 2, 0.01, at_once});
      const Bracket bracket = bracket_of(trials);
      ASSERT_TRUE(bracket.stands && bracket.fails) << factor;
      EXPECT_LE(*bracket.stands, factor);
      EXPECT_GT(*bracket.fails, factor);
    }
}

TEST(SafetySearch, gives_up_at_its_limits)
{
  std::vector<Trial> never, always;
  search(never, soil_of(0), {1, 2, 0.01, 2});
  EXPECT_FALSE(bracket_of(never).stands);
  EXPECT_EQ(bracket_of(never).fails, min_factor);
  search(always, soil_of(100), {1, 2, 0.01, 2});
  EXPECT_FALSE(bracket_of(always).fails);
  EXPECT_EQ(bracket_of(always).stands, max_factor);
}

TEST(SafetySearch, narrows_both_sides_of_factors_at_which_neither_is_known)
{
  const Answer soil = [](Real f) { return f < 1.31 ? TrialEnd::stands : f < 1.36 ? TrialEnd::undecided : TrialEnd::fails; };
  for (const int at_once : {1, 2, 3}) {
    std::vector<Trial> trials;
    search(trials, soil, {1, 2, 0.01, at_once});
    const Bracket bracket = bracket_of(trials);
    ASSERT_FALSE(bracket.undecided.empty());
    EXPECT_LE(bracket.undecided.front() - *bracket.stands, 0.01 * (1 + 1e-9));
    EXPECT_LE(*bracket.fails - bracket.undecided.back(), 0.01 * (1 + 1e-9));
    EXPECT_LT(*bracket.stands, 1.31);
    EXPECT_GE(*bracket.fails, 1.36);
  }
}

TEST(SafetySearch, ends_where_no_trial_tells_anything)
{
  std::vector<Trial> trials;
  search(trials, [](Real) { return TrialEnd::undecided; }, {1, 2, 0.01, 2});
  EXPECT_FALSE(bracket_of(trials).stands || bracket_of(trials).fails);
}

TEST(SafetySearch, goes_on_from_the_trials_of_a_search_that_was_stopped_or_was_coarser)
{
  std::vector<Trial> trials;
  search(trials, soil_of(1.38), {1, 2, 0.1, 2});
  const std::size_t coarse = trials.size();
  search(trials, soil_of(1.38), {1, 2, 0.01, 1});
  EXPECT_LT(trials.size() - coarse, 5u) << "0.1 to 0.01 takes four halves";
}

TEST(SafetyBracket, ends_at_the_smallest_factor_that_fails_and_names_those_above_it_that_stand)
{
  const Bracket bracket = bracket_of(
      {{1, TrialEnd::stands}, {1.5, TrialEnd::fails}, {1.6, TrialEnd::stands}, {1.3, TrialEnd::undecided}, {2, TrialEnd::fails}});
  EXPECT_EQ(bracket.stands, 1);
  EXPECT_EQ(bracket.fails, 1.5);
  EXPECT_EQ(bracket.undecided, (std::vector<Real>{1.3}));
  EXPECT_EQ(bracket.stands_above, (std::vector<Real>{1.6}));
}

}  // namespace
}  // namespace berm::safety::this_file
