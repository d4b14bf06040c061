// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands.hpp"

#include <gtest/gtest.h>

namespace berm::uncertainty::this_file {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

/// The sizes that a band is made of.
constexpr Real sizes[] = {1, 1.4, 1.6, 1.8, 2, 2.2};

template <class F>
std::vector<SizedNumber> numbers_of(const F& number)
{
  std::vector<SizedNumber> numbers;
  for (const Real size : sizes) numbers.push_back({size, number(size)});
  return numbers;
}

/// Whether the band of these numbers, with nothing else uncertain, holds the exact one.
bool holds(const std::vector<SizedNumber>& numbers, Real exact)
{
  const Estimate e = extrapolate(numbers);
  return std::abs(e.converged - exact) <= half_width(e.extrapolation, e.mesh, 0, 0);
}

TEST(Estimate, of_numbers_of_first_order_is_exact)
{
  const Estimate e = extrapolate(numbers_of([](Real h) { return 700 + 100 * h; }));
  EXPECT_NEAR(e.converged, 700, 1e-9);
  EXPECT_NEAR(e.extrapolation, 50, 1e-9);  // half of the way of 100
  EXPECT_NEAR(e.mesh, 0, 1e-9);
}

TEST(Estimate, of_numbers_from_below_goes_up)
{
  const Estimate e = extrapolate(numbers_of([](Real h) { return 700 - 100 * h; }));
  EXPECT_NEAR(e.converged, 700, 1e-9);
  EXPECT_NEAR(e.extrapolation, 50, 1e-9);
}

TEST(Estimate, of_equal_numbers_has_no_width)
{
  const Estimate e = extrapolate({{1, 5}, {1.5, 5}, {2, 5}});
  EXPECT_EQ(e.converged, 5);
  EXPECT_EQ(e.extrapolation, 0);
  EXPECT_EQ(e.mesh, 0);
}

TEST(Estimate, holds_the_exact_number_for_orders_from_three_quarters_to_three_halves)
{
  for (const Real order : {0.75, 0.9, 1., 1.2, 1.5})
    for (const Real sign : {1, -1}) EXPECT_TRUE(holds(numbers_of([&](Real h) { return 10 + sign * std::pow(h, order); }), 10)) << order;
}

// Without scatter an order of 1/2 is beyond what the band is for: a band that held it, too, would tell nothing.
TEST(Estimate, does_not_hold_it_for_an_order_of_one_half)
{
  EXPECT_FALSE(holds(numbers_of([](Real h) { return 10 + std::sqrt(h); }), 10));
}

TEST(Estimate, of_numbers_that_go_up_and_down_is_as_wide_as_they_scatter)
{
  const Estimate e = extrapolate({{1, 10}, {1.4, 12}, {1.6, 9}, {1.8, 12}, {2, 9}, {2.2, 11}});
  EXPECT_GT(e.mesh, 3);
  EXPECT_LT(std::abs(e.converged - 10.5), e.mesh);
}

/// A number in [0, 1) from another, by a linear congruence: the same everywhere.
Real next(std::uint32_t& state)
{
  state = 1664525 * state + 1013904223;
  return state / 4294967296.;
}

/// A normal number with deviation 1, by Box and Muller.
Real normal(std::uint32_t& state)
{
  const Real a = next(state), b = next(state);
  return std::sqrt(-2 * std::log(1 - a)) * std::cos(2 * pi * b);
}

// Of a thousand sets the share of a band of 95 % has a standard deviation of 0.7 %: 2.1 % is three of them.
TEST(Estimate, of_numbers_that_scatter_in_proportion_to_the_cells_holds_19_of_20_by_the_mesh_alone)
{
  std::uint32_t state = 1;
  int held = 0;
  for (int set = 0; set < 1000; ++set) {
    const Estimate e = extrapolate(numbers_of([&](Real h) { return 700 + 100 * h + 20 * h * normal(state); }));
    held += std::abs(e.converged - 700) <= e.mesh;
  }
  EXPECT_NEAR(held / 1000., 0.95, 0.021);
}

TEST(Estimate, of_too_few_numbers_or_one_that_is_missing_is_none)
{
  EXPECT_TRUE(std::isnan(extrapolate({{1, 5}, {2, 6}}).converged));
  EXPECT_TRUE(std::isnan(extrapolate({{1, 5}, {1, 6}, {1, 7}}).converged));
  EXPECT_TRUE(std::isnan(extrapolate({{1, 5}, {1.5, nan}, {2, 7}}).converged));
}

TEST(HalfWidth, adds_independent_parts_by_their_squares_and_the_extrapolation_as_it_is)
{
  EXPECT_NEAR(half_width(1, 2, 1, 2), 4, 1e-12);
  EXPECT_TRUE(std::isnan(half_width(1, nan, 0, 0)));
}

TEST(Student, is_wide_for_few_numbers_and_comes_near_to_two)
{
  EXPECT_TRUE(std::isnan(student_95(0)));
  EXPECT_EQ(student_95(4), 2.776);
  EXPECT_EQ(student_95(30), 2.228);  // the last in the table: on the safe side
}

}  // namespace
}  // namespace berm::uncertainty::this_file
