// SPDX-License-Identifier: BSD-3-Clause
#include "study/estimates.hpp"

#include "study/sample.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::study::this_file {
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

/// Relative error of the 95 % quantile of exp(0.2 x + 0.1 y + 0.05 z), x, y and z standard normal, over many samples, in percent.
struct QuantileError {
  Real bias, deviation;
};
template <class Shares>
QuantileError error_of_quantile(int samples, const Shares& shares)
{
  const std::vector<Real> scale = {0.2, 0.1, 0.05};
  const Real exact = std::exp(std::sqrt(0.2 * 0.2 + 0.1 * 0.1 + 0.05 * 0.05) * standard_normal_quantile(0.95));
  Real sum = 0, squares = 0;
  for (int seed = 1; seed <= samples; ++seed) {
    const std::vector<std::vector<Real>> of = shares(static_cast<std::uint64_t>(seed));
    std::vector<Real> values(of[0].size(), 0);
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (std::size_t p = 0; p < scale.size(); ++p) values[k] += scale[p] * standard_normal_quantile(of[p][k]);
      values[k] = std::exp(values[k]);
    }
    const Real error = 100 * (sample_quantile(values, 0.95) / exact - 1);
    sum += error, squares += error * error;
  }
  const Real bias = sum / samples;
  return {bias, std::sqrt(squares / samples - bias * bias)};
}
TEST(SampleStatistics, quantiles_of_hypercubes_and_of_independent_rows_err_as_decided_on)
{
  // The table of docs/decisions/0033-samples-in-studies.md. The mean of 400 samples is uncertain by a twentieth of their deviation, the deviation by 1 in 28; four of each.
  constexpr int samples = 400;
  const auto expect = [](const QuantileError& error, Real bias, Real deviation) {
    EXPECT_NEAR(error.bias, bias, 4 * deviation / std::sqrt(samples));
    EXPECT_NEAR(error.deviation, deviation, 4 * deviation / std::sqrt(2. * samples));
  };
  struct Row {
    std::size_t rows;
    Real bias, deviation, independent_bias, independent_deviation;
  };
  for (const Row& row :
       {Row{20, 2.2, 7.7, 1.0, 10.1}, Row{50, 0.2, 4.9, -0.3, 6.7}, Row{100, 0.3, 3.4, 0.1, 4.5}, Row{200, 0.2, 2.4, -0.1, 3.3}}) {
    SCOPED_TRACE(row.rows);
    expect(error_of_quantile(samples, [&](std::uint64_t seed) { return latin_hypercube(3, row.rows, seed); }), row.bias, row.deviation);
    std::mt19937_64 generator(1);
    const auto independent = [&](std::uint64_t) {
      std::vector<std::vector<Real>> shares(3, std::vector<Real>(row.rows));
      for (std::vector<Real>& of_one : shares)
        for (Real& share : of_one) share = (static_cast<Real>(generator() >> 11) + 0.5) / 9007199254740992.;
      return shares;
    };
    expect(error_of_quantile(samples, independent), row.independent_bias, row.independent_deviation);
  }
}
TEST(SampleStatistics, the_mean_is_that_of_all)
{
  EXPECT_NEAR(mean_of(ten()), 5.5, rounding);
}
TEST(SampleStatistics, spread_is_that_of_numbers_and_of_their_logarithms)
{
  // 1, e, e^2: deviations by n - 1; two of three lie below 5, of which (2 + 1)/(3 + 2) makes the error.
  const Real e = std::exp(1.);
  const Spread spread = spread_of({e, 1, e * e}, 5);
  const Real mean = (1 + e + e * e) / 3;
  EXPECT_NEAR(spread.deviation, std::sqrt((std::pow(1 - mean, 2) + std::pow(e - mean, 2) + std::pow(e * e - mean, 2)) / 2), rounding);
  EXPECT_NEAR(spread.log_mean, 1, rounding);
  EXPECT_NEAR(spread.log_deviation, 1, rounding);
  EXPECT_NEAR(spread.below, 2. / 3, rounding);
  EXPECT_NEAR(spread.below_error, std::sqrt(0.6 * 0.4 / 3), rounding);
  EXPECT_NEAR(spread.below_by_lognormal, 0.5 * std::erfc(-(std::log(5.) - 1) / std::sqrt(2.)), rounding);
}
TEST(SampleStatistics, spread_knows_no_lognormal_of_negative_numbers_and_no_scatter_of_one)
{
  const Spread negative = spread_of({-1, 2}, {});
  EXPECT_TRUE(std::isnan(negative.log_mean) && std::isnan(negative.below));
  EXPECT_NEAR(negative.deviation, 3 / std::sqrt(2.), rounding);
  EXPECT_TRUE(std::isnan(spread_of({1}, {}).deviation));
  EXPECT_TRUE(std::isnan(spread_of({}, 1).below));
  const Spread none_below = spread_of({2, 3, 4, 5}, 1);
  EXPECT_EQ(none_below.below, 0);
  EXPECT_NEAR(none_below.below_error, std::sqrt(5. / 36 / 4), rounding) << "no number below is no certainty";
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
}  // namespace berm::study::this_file
