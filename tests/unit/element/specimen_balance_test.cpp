// SPDX-License-Identifier: BSD-3-Clause
#include "element/specimen.hpp"

#include <gtest/gtest.h>

namespace berm::element::this_file {
namespace {

constexpr Real tolerance = 1e-9;

std::optional<Real> solve(const std::function<Real(Real)>& excess, Real guess = 0)
{
  return balance(excess, {.guess = guess, .step = 1e-3, .limit = 1, .tolerance = tolerance});
}

TEST(Balance, is_found_on_a_line_on_a_curve_and_over_a_kink)
{
  const std::vector<std::function<Real(Real)>> all = {[](Real x) { return 1e7 * (x - 0.02); }, [](Real x) { return std::exp(40 * x) - 3; },
                                                      [](Real x) { return x < 0.1 ? 1e3 * (x - 0.1) - 1 : 10 * (x - 0.2); },
                                                      [](Real x) { return std::atan(1e4 * (x + 0.3)); }};
  for (const auto& excess : all) {
    const std::optional<Real> x = solve(excess);
    ASSERT_TRUE(x);
    EXPECT_LE(std::abs(excess(*x)), tolerance);
  }
}

TEST(Balance, is_the_guess_where_that_is_right)
{
  EXPECT_EQ(solve([](Real x) { return x < 0.2 ? -1 : 0.; }, 0.3), 0.3);
}

TEST(Balance, is_beside_a_jump_that_is_small)
{
  const auto excess = [](Real x) { return 1e7 * (x - 0.02) + (x < 0.02 ? -3. : 3.); };
  const std::optional<Real> x = balance(excess, {.guess = 0, .step = 1e-3, .limit = 1, .tolerance = tolerance, .jump = 4});
  ASSERT_TRUE(x);
  EXPECT_NEAR(*x, 0.02, 1e-6);
  EXPECT_FALSE(balance(excess, {.guess = 0, .step = 1e-3, .limit = 1, .tolerance = tolerance, .jump = 2}));
}

TEST(Balance, is_empty_where_no_strain_gives_the_stress)
{
  EXPECT_FALSE(solve([](Real) { return -1.; })) << "never reached";
  EXPECT_FALSE(solve([](Real x) { return x - 2; })) << "beyond the limit";
  EXPECT_FALSE(solve([](Real x) { return x - 2; }, 2)) << "beyond the limit, and guessed";
  EXPECT_FALSE(solve([](Real x) { return x < 0.1 ? -1. : 1.; })) << "jumps over it";
  EXPECT_FALSE(solve([](Real x) { return std::sqrt(-1 - x * x); })) << "not finite";
}

}  // namespace
}  // namespace berm::element::this_file
