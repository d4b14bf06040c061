// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample_statistics.hpp"

#include <gtest/gtest.h>

namespace berm::study {
namespace {

constexpr Real rounding = 1e-12;  // of sums and products of some units

std::vector<Real> ten()
{
  return {3, 1, 2, 10, 9, 8, 7, 6, 5, 4};
}

TEST(SampleStatistics, quantiles_lie_at_the_middles_of_steps)
{
  EXPECT_NEAR(sample_quantile(ten(), 0.05), 1, rounding);
  EXPECT_NEAR(sample_quantile(ten(), 0.95), 10, rounding);
  EXPECT_NEAR(sample_quantile(ten(), 0.5), 5.5, rounding);
  EXPECT_NEAR(sample_quantile(ten(), 0.18), 2.3, rounding);
  EXPECT_NEAR(sample_quantile({7}, 0.5), 7, rounding);
}
TEST(SampleStatistics, quantiles_beyond_the_sample_are_not_known)
{
  std::vector<Real> nine = ten();
  nine.pop_back();
  EXPECT_TRUE(std::isnan(sample_quantile(nine, 0.05)));
  EXPECT_TRUE(std::isnan(sample_quantile(nine, 0.95)));
  EXPECT_TRUE(std::isnan(sample_quantile({}, 0.5)));
  EXPECT_TRUE(std::isnan(mean_of({})));
}
TEST(SampleStatistics, the_mean_is_that_of_all)
{
  EXPECT_NEAR(mean_of(ten()), 5.5, rounding);
}
TEST(SampleStatistics, rank_correlation_knows_order_alone)
{
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1e9}), 1, rounding);
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {8, 4, 2, 1}), -1, rounding);
  // Places 0 1 2 3 and 1 0 3 2: 1 - 6 (1 + 1 + 1 + 1) / (4 (16 - 1)).
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {2, 1, 4, 3}), 0.6, rounding);
  // Equal ones share their places, 0 1.5 1.5 3 beside 0 1 2 3: 4.5 / sqrt(4.5 * 5).
  EXPECT_NEAR(rank_correlation({1, 2, 2, 4}, {1, 2, 3, 4}), 4.5 / std::sqrt(22.5), rounding);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3})));
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2}, {1, 2})));
}

}  // namespace
}  // namespace berm::study
