// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/divide.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace berm::mpm::this_file {
namespace {

TEST(EqualShares, of_equal_chunks_are_equal)
{
  EXPECT_EQ(equal_shares(std::vector<Real>(8, 1), 4), (std::vector<Index>{0, 2, 4, 6, 8}));
  EXPECT_EQ(equal_shares(std::vector<Real>(8, 1), 1), (std::vector<Index>{0, 8}));
}

TEST(EqualShares, are_beside_each_other_by_no_more_than_a_chunk)
{
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Real> costs(20 + random() % 300);
    for (Real& cost : costs) cost = random() % 3 == 0 ? 0 : std::uniform_real_distribution<Real>(0, 1)(random);
    const Real all = std::accumulate(costs.begin(), costs.end(), Real(0)), most = *std::max_element(costs.begin(), costs.end());
    for (const int ranks : {2, 3, 7}) {
      const std::vector<Index> first = equal_shares(costs, ranks);
      ASSERT_EQ(first.size(), static_cast<std::size_t>(ranks) + 1);
      EXPECT_EQ(first.front(), 0);
      EXPECT_EQ(first.back(), static_cast<Index>(costs.size()));
      for (int r = 0; r < ranks; ++r) {
        ASSERT_LT(first[r], first[r + 1]);
        EXPECT_NEAR(std::accumulate(costs.begin() + first[r], costs.begin() + first[r + 1], Real(0)), all / ranks, most);
      }
    }
  }
}

TEST(EqualShares, of_fewer_chunks_than_ranks_leave_some_without)
{
  const std::vector<Index> first = equal_shares({1, 1}, 4);
  EXPECT_EQ(first.front(), 0);
  EXPECT_EQ(first.back(), 2);
  EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
}

TEST(EqualShares, of_nothing_are_still_all_chunks)
{
  const std::vector<Index> first = equal_shares(std::vector<Real>(6, 0), 3);
  EXPECT_EQ(first.front(), 0);
  EXPECT_EQ(first.back(), 6);
  EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
}

}  // namespace
}  // namespace berm::mpm::this_file
