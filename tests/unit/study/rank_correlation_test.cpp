// SPDX-License-Identifier: BSD-3-Clause
#include "study/rank_correlation.hpp"

#include "study/sample.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::study::this_file {
namespace {

using Shares = std::vector<std::vector<Real>>;
const std::vector<std::string> names = {"a", "b", "c"};

/// What check says, line by line.
class Refusals : public Describe {
public:
  std::vector<std::string> said;

  void check(bool holds, const std::string& key, const std::string& message, const std::vector<std::string>& /*known*/) override
  {
    if (!holds) said.push_back(key + ": " + message);
  }

protected:
  void leaf(const char* /*key*/, Leaf /*variable*/, const Parameter& /*parameter*/) override {}
  void enter(const char* /*key*/, const Parameter& /*parameter*/) override {}
  void leave() override {}
  bool has_table(const char* /*key*/, bool present) override { return present; }
  std::vector<std::string> names_in(const char* /*key*/, const std::vector<std::string>& present, const Parameter& /*parameter*/) override
  {
    return present;
  }
  void enter_named(const char* /*key*/, const std::string& /*name*/) override {}
  int count_in(const char* /*key*/, int present, const Parameter& /*parameter*/) override { return present; }
  void enter_item(const char* /*key*/, int /*item*/) override {}
  int choose(const char* /*key*/, const std::vector<const char*>& /*names*/, int now, const Parameter& /*parameter*/) override
  {
    return now;
  }
};

TEST(RankCorrelations, of_a_sample_are_those_that_were_asked_for)
{
  // Of rows that are drawn with a correlation r that of the sample deviates by about (1 - r^2)/sqrt(n - 1) <= 1/sqrt(n - 1). Iman and Conover take out what the scores have by chance; what is left comes of the
  // order alone: half of it at most in the root mean square of 100 samples. The mean of these misses by 1/n at most, the size of what normal scores of n rows lack in their tails.
  const std::vector<SampleCorrelation> wanted = {{{"a", "b"}, 0.7}, {{"b", "c"}, -0.4}};
  constexpr int samples = 100;
  for (const std::size_t rows : {50, 400}) {
    const auto n = static_cast<Real>(rows);
    const std::tuple<int, int, Real> pairs[] = {{0, 1, 0.7}, {1, 2, -0.4}, {0, 2, 0}};
    for (const auto& [a, b, rank] : pairs) {
      Real sum = 0, squares = 0;
      for (int seed = 1; seed <= samples; ++seed) {
        const Shares shares = with_rank_correlations(latin_hypercube(3, rows, static_cast<std::uint64_t>(seed)), wanted, names);
        const Real error = rank_correlation(shares[a], shares[b]) - rank;
        sum += error / samples;
        squares += error * error / samples;
      }
      EXPECT_LT(std::sqrt(squares), 0.5 / std::sqrt(n - 1)) << rows << " " << rank;
      EXPECT_NEAR(sum, 0, 1 / n + 4 * std::sqrt(squares / samples)) << rows << " " << rank;
    }
  }
}
TEST(RankCorrelations, leave_each_parameter_its_numbers_and_the_first_its_order)
{
  const Shares before = latin_hypercube(3, 40, 5);
  Shares after = with_rank_correlations(before, {{{"a", "c"}, 0.9}}, names);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_NE(after[2], before[2]);
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Real> one = before[j], two = after[j];
    std::sort(one.begin(), one.end());
    std::sort(two.begin(), two.end());
    EXPECT_EQ(one, two);
  }
}
TEST(RankCorrelations, that_are_not_asked_for_change_nothing)
{
  EXPECT_EQ(with_rank_correlations(latin_hypercube(3, 40, 5), {}, names), latin_hypercube(3, 40, 5));
}
TEST(RankCorrelations, that_contradict_each_other_are_refused_with_what_is_possible)
{
  // a with b, b with c, and c against a. 2 sin(pi/6 * 0.9) = 0.908: eigenvalues 1 + 0.908 (twice) and 1 - 2 * 0.908 = -0.816; times 0.55 the least is 0.01.
  Refusals refusals;
  check(refusals, {{{"a", "b"}, 0.9}, {{"b", "c"}, 0.9}, {{"a", "c"}, -0.9}}, names, 50);
  ASSERT_EQ(refusals.said.size(), 1u);
  EXPECT_NE(refusals.said[0].find("sample.correlation: contradict each other"), std::string::npos) << refusals.said[0];
  EXPECT_NE(refusals.said[0].find("least eigenvalue is -0.816). All of them times 0.55 are possible"), std::string::npos)
      << refusals.said[0];
}
TEST(RankCorrelations, of_what_is_no_pair_are_refused)
{
  Refusals refusals;
  check(refusals, {{{"a"}, 0.5}, {{"a", "d"}, 0.5}, {{"a", "b"}, 0.5}, {{"b", "a"}, 0.2}}, names, 3);
  ASSERT_EQ(refusals.said.size(), 4u);
  EXPECT_NE(refusals.said[0].find("correlation[0].parameters: needs the names of two parameters"), std::string::npos);
  EXPECT_NE(refusals.said[1].find("correlation[1].parameters: there is no parameter \"d\""), std::string::npos);
  EXPECT_NE(refusals.said[2].find("correlation[3].parameters: is given twice"), std::string::npos);
  EXPECT_NE(refusals.said[3].find("sample.size"), std::string::npos);
}
TEST(RankCorrelations, of_scores_follow_order_alone)
{
  EXPECT_EQ(places_of({3, 1, 2, 2}), (std::vector<Real>{3, 0, 1.5, 1.5}));
}

}  // namespace
}  // namespace berm::study::this_file
