// SPDX-License-Identifier: BSD-3-Clause
#include "material/exponential.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::material::this_file {
namespace {

// Some roundings of 1.1e-16 each in a polynomial and a product.
constexpr Real accuracy = 1e-15;

TEST(Exponential, is_that_of_the_standard_library)
{
  std::mt19937_64 random(1);
  for (const Real range : {1e-12, 1e-3, 1., 30., 699.}) {
    std::uniform_real_distribution<Real> number(-range, range);
    for (int k = 0; k < 20000; ++k) {
      const Real x = number(random);
      ASSERT_NEAR(exponential(x) / std::exp(x), 1, accuracy) << x;
    }
  }
  EXPECT_EQ(exponential(0.), 1);
}

TEST(Exponential, of_a_number_too_large_or_too_small_stays_finite)
{
  EXPECT_EQ(exponential(1e9), exponential(700.));
  EXPECT_EQ(exponential(-1e9), exponential(-700.));
  EXPECT_TRUE(std::isfinite(exponential(700.)));
  EXPECT_GT(exponential(-700.), 0);
}

TEST(Logarithm, is_that_of_the_standard_library)
{
  std::mt19937_64 random(2);
  for (const Real range : {1e-9, 1e-2, 1., 30., 700.}) {
    std::uniform_real_distribution<Real> number(-range, range);
    for (int k = 0; k < 20000; ++k) {
      const Real x = std::exp(number(random));
      // log(x) of a number near 1 has the rounding of x - 1, the same in both.
      ASSERT_NEAR(logarithm(x), std::log(x), accuracy * std::abs(std::log(x))) << x;
    }
  }
  EXPECT_EQ(logarithm(1.), 0);
}

TEST(Exponential, each_lane_has_the_bits_that_it_has_in_any_other_place)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> number(-50, 50);
  for (int k = 0; k < 10000; ++k) {
    Lanes x, turned;
    for (int l = 0; l < lanes; ++l) x[l] = number(random);
    for (int l = 0; l < lanes; ++l) turned[l] = x[(l + 1) % lanes];
    const Lanes power = exponential(x), again = exponential(turned), log = logarithm(power), log_again = logarithm(again);
    for (int l = 0; l < lanes; ++l) {
      ASSERT_EQ(again[l], power[(l + 1) % lanes]);
      ASSERT_EQ(log_again[l], log[(l + 1) % lanes]);
      // The compiler may fuse products and sums in one form and not in the other.
      ASSERT_NEAR(power[l] / exponential(x[l]), 1, accuracy);
    }
  }
}

TEST(Exponential, derivatives_are_those_of_the_functions)
{
  Dual x{0.7, {1, 2, 0, 0}};
  EXPECT_EQ(exponential(x).slope[1], 2 * exponential(0.7));
  EXPECT_EQ(logarithm(x).slope[0], 1 / 0.7);
}

}  // namespace
}  // namespace berm::material::this_file
