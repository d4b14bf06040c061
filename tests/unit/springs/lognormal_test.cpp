// SPDX-License-Identifier: BSD-3-Clause
#include "springs/lognormal.hpp"

#include "study/sample.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::springs::this_file {
namespace {

TEST(Lognormal, finds_the_distribution_that_its_values_are_quantiles_of)
{
  std::vector<Real> values;
  constexpr int n = 1000;
  for (int k = 0; k < n; ++k) values.push_back(std::exp(1.5 + 0.3 * study::standard_normal_quantile((k + 0.5) / n)));
  const Lognormal fit = fit_lognormal(values);
  EXPECT_NEAR(fit.mean, 1.5, 1e-10);
  EXPECT_NEAR(fit.deviation, 0.3, 2e-3);
  EXPECT_NEAR(fit.quantile(0.5), std::exp(1.5), 1e-9);
  EXPECT_NEAR(fit.quantile(0.95), std::exp(1.5 + 1.644853627 * fit.deviation), 1e-8);
  EXPECT_LT(fit.distance, 0.1) << "half a place of a thousand, times their root";
  EXPECT_TRUE(fit.fits());
}

TEST(Lognormal, refuses_five_of_a_hundred_samples_that_are_and_nearly_all_that_are_not)
{
  std::mt19937 random(3);
  std::lognormal_distribution<Real> lognormal(2, 0.5);
  std::bernoulli_distribution coin(0.5);
  constexpr int samples = 2000;
  int refused = 0, two_values_refused = 0;
  for (int s = 0; s < samples; ++s) {
    std::vector<Real> is, is_not;
    for (int k = 0; k < 30; ++k)
      is.push_back(lognormal(random)), is_not.push_back(std::exp((coin(random) ? 1 : -1) + 0.1 * std::log(lognormal(random))));
    refused += !fit_lognormal(is).fits();
    two_values_refused += !fit_lognormal(is_not).fits();
  }
  // The share of 5 % has a deviation of 0.5 % over 2000 samples; Stephens' limit is good to as much.
  EXPECT_NEAR(refused / Real(samples), 0.05, 0.02);
  EXPECT_GT(two_values_refused, 0.99 * samples);
}

TEST(Lognormal, is_unknown_of_few_values_of_equal_ones_and_where_one_is_not_positive)
{
  for (const std::vector<Real>& values : {std::vector<Real>{}, {1, 2, 3, 4}, {2, 2, 2, 2, 2.0001}, {1, 2, 3, 4, 0}, {1, 2, 3, 4, -1}}) {
    EXPECT_TRUE(std::isnan(fit_lognormal(values).mean));
    EXPECT_FALSE(fit_lognormal(values).fits());
  }
}

}  // namespace
}  // namespace berm::springs::this_file
