// SPDX-License-Identifier: BSD-3-Clause
#include "core/dual.hpp"
#include "core/lanes.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::this_file {
namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// f(x, y) with x the first unknown and y the last, against central differences of f at 10 000 points away from 0.
template <class Function>
void expect_slope_of_differences(const char* name, Function f)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> number(0.5, 2);
  for (int trial = 0; trial < 10000; ++trial) {
    const Real x = number(random), y = number(random), h = 1e-5;
    const Dual result = f(Dual{x, {1, 0, 0, 0}}, Dual{y, {0, 0, 0, 1}});
    ASSERT_EQ(result.value, f(x, y)) << name;
    if (std::abs(x - y) < h) continue;  // a kink of larger and smaller
    // Third derivatives here are at most 6 * 2 / 0.5^4: their share is h^2 / 6 of that; rounding adds 1e-15 / h.
    ASSERT_NEAR(result.slope[0], (f(x + h, y) - f(x - h, y)) / (2 * h), 1e-8) << name << " " << x << " " << y;
    ASSERT_NEAR(result.slope[3], (f(x, y + h) - f(x, y - h)) / (2 * h), 1e-8) << name << " " << x << " " << y;
    ASSERT_EQ(result.slope[1], 0) << name;
    ASSERT_EQ(result.slope[2], 0) << name;
  }
}

TEST(Dual, arithmetic_follows_the_rules_of_differentiation)
{
  expect_slope_of_differences("x + y", [](auto x, auto y) { return x + y; });
  expect_slope_of_differences("x - y", [](auto x, auto y) { return x - y; });
  expect_slope_of_differences("x y", [](auto x, auto y) { return x * y; });
  expect_slope_of_differences("x / y", [](auto x, auto y) { return x / y; });
  expect_slope_of_differences("-x", [](auto x, auto) { return -x; });
  expect_slope_of_differences("root of x y", [](auto x, auto y) { return square_root(x * y); });
}

TEST(Dual, a_plain_number_has_no_slope)
{
  expect_slope_of_differences("x + 3", [](auto x, auto) { return x + 3.; });
  expect_slope_of_differences("3 + x", [](auto x, auto) { return 3. + x; });
  expect_slope_of_differences("x - 3", [](auto x, auto) { return x - 3.; });
  expect_slope_of_differences("3 - x", [](auto x, auto) { return 3. - x; });
  expect_slope_of_differences("x 3", [](auto x, auto) { return x * 3.; });
  expect_slope_of_differences("3 x", [](auto x, auto) { return 3. * x; });
  expect_slope_of_differences("x / 3", [](auto x, auto) { return x / 3.; });
  expect_slope_of_differences("3 / y", [](auto, auto y) { return 3. / y; });
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(Dual{}.slope[k], 0);
    EXPECT_EQ((Dual{} + 1.).slope[k], 0);
  }
  EXPECT_EQ((infinity - Dual{}).value, infinity);
}

TEST(Dual, changing_a_number_in_place_is_the_operation)
{
  expect_slope_of_differences("all four", [](auto x, auto y) {
    auto z = x;
    z += y;
    z *= x;
    z -= y;
    z /= y;
    return z;
  });
  expect_slope_of_differences("all four, plain", [](auto x, auto) {
    auto z = x;
    z += 3.;
    z *= z;
    z -= 1.;
    z /= 7.;
    return z;
  });
}

TEST(Dual, larger_smaller_and_magnitude_take_the_slope_of_what_they_choose)
{
  expect_slope_of_differences("larger", [](auto x, auto y) { return larger(x * x, y * y); });
  expect_slope_of_differences("smaller", [](auto x, auto y) { return smaller(x * x, y * y); });
  expect_slope_of_differences("magnitude", [](auto x, auto y) { return magnitude(x - y); });
}

TEST(Dual, larger_and_smaller_of_two_equal_numbers_are_one_of_each)
{
  const Dual first{2, {1, 0, 0, 0}}, second{2, {0, 1, 0, 0}};
  EXPECT_EQ(larger(first, second).slope[1], 1);
  EXPECT_EQ(smaller(first, second).slope[0], 1);
}

TEST(Dual, comparison_looks_at_the_value_alone)
{
  const Real numbers[] = {-infinity, -1, 0, 1, infinity, not_a_number};
  for (const Real x : numbers)
    for (const Real y : numbers) {
      const Dual a{x, {1, 2, 3, 4}}, b{y, {4, 3, 2, 1}};
      EXPECT_EQ(a < b, x < y);
      EXPECT_EQ(a <= b, x <= y);
      EXPECT_EQ(a > b, x > y);
      EXPECT_EQ(a >= b, x >= y);
      EXPECT_EQ(a < y, x < y);
      EXPECT_EQ(a <= y, x <= y);
      EXPECT_EQ(a > y, x > y);
      EXPECT_EQ(a >= y, x >= y);
    }
}

TEST(Dual, the_root_of_zero_has_no_slope)
{
  const Dual root = square_root(Dual{0, {1, 2, 3, 4}});
  EXPECT_EQ(root.value, 0);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(root.slope[k], 0);
}

}  // namespace
}  // namespace berm::this_file
