// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample.hpp"

#include <gtest/gtest.h>

namespace berm::study::this_file {
namespace {

using enum DistributionKind;

Distribution made(DistributionKind kind, Real low, std::optional<Real> best, Real high)
{
  Distribution made;
  made.kind = kind;
  made.low = low;
  made.best = best;
  made.high = high;
  return made;
}

/// Of values of some units: what bisection to 1e-15 and erfc leave.
constexpr Real rounding = 1e-12;

TEST(Distribution, standard_normal_quantiles_are_those_of_tables)
{
  EXPECT_NEAR(standard_normal_quantile(0.95), 1.6448536269514722, rounding);
  EXPECT_NEAR(standard_normal_quantile(0.025), -1.959963984540054, rounding);
  EXPECT_NEAR(standard_normal_quantile(0.5), 0, rounding);
  EXPECT_NEAR(standard_normal_quantile(1e-9), -5.997807015007686, 1e-9) << "1e-9 of a share has seven digits less";
}
TEST(Distribution, uniform_and_triangular_ones_end_at_low_and_high)
{
  EXPECT_NEAR(quantile(made(uniform, 2, {}, 6), 0.25), 3, rounding);
  // Density up to 1/2 at the peak 3 of 2 to 6: a quarter of all lies below it, (x - 2)^2 / 4 before it and 1 - (6 - x)^2 / 12 behind it.
  const Distribution peaked = made(triangular, 2, 3, 6);
  EXPECT_NEAR(quantile(peaked, 0.25), 3, rounding);
  EXPECT_NEAR(quantile(peaked, 0.16), 2.8, rounding);
  EXPECT_NEAR(quantile(peaked, 0.75), 6 - std::sqrt(3.), rounding);
  EXPECT_NEAR(quantile(made(triangular, 2, 2, 6), 0.75), 4, rounding) << "the peak at an end";
  EXPECT_NEAR(quantile(made(triangular, 2, 6, 6), 0.25), 4, rounding);
}
TEST(Distribution, normal_and_lognormal_ones_have_their_estimates_as_quantiles)
{
  for (const Distribution& d : {made(normal, -1, 0, 3), made(normal, 1, 2, 3), made(lognormal, 1, 3, 4), made(lognormal, 1, 2, 4)}) {
    EXPECT_NEAR(quantile(d, 0.05), d.low, rounding);
    EXPECT_NEAR(quantile(d, 0.5), *d.best, rounding);
    EXPECT_NEAR(quantile(d, 0.95), d.high, rounding);
  }
  EXPECT_NEAR(quantile(made(normal, 1, {}, 4), 0.5), 2.5, rounding) << "without best: the middle";
  EXPECT_NEAR(quantile(made(lognormal, 1, {}, 4), 0.5), 2, rounding) << "the middle of logarithms";
  EXPECT_NEAR(quantile(made(lognormal, 1, {}, 4), 0.9), 2 * std::exp(std::log(2.) * 1.2815515655446004 / 1.6448536269514722), rounding);
}
TEST(Distribution, that_is_cut_keeps_its_shape_within)
{
  Distribution cut = made(normal, -1, {}, 1);
  cut.min = -1;
  // What lies above -1, 95 %, is all: the share 0.5 of it begins at 0.05 + 0.475 of the whole.
  EXPECT_NEAR(quantile(cut, 0.5), standard_normal_quantile(0.525) / standard_normal_quantile(0.95), rounding);
  EXPECT_NEAR(quantile(cut, 1e-15), -1, rounding);
  cut.max = 1;
  EXPECT_NEAR(quantile(cut, 0.5), 0, rounding);
  EXPECT_NEAR(quantile(cut, 1 - 1e-15), 1, rounding);
  Distribution logarithmic = made(lognormal, 1, {}, 4);
  logarithmic.min = 0;
  EXPECT_NEAR(quantile(logarithmic, 0.5), 2, rounding) << "none lies below 0 anyway";
}

}  // namespace
}  // namespace berm::study::this_file
