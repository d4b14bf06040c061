// SPDX-License-Identifier: BSD-3-Clause
#include "problem/pressure_means.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real window = 2;  // s: two periods of the slowest swing

/// The means of a pressure that is noted a hundred times in each window, from 0 to a time.
PressureMeans means_of(const std::function<Real(Real)>& pressure, Real until)
{
  constexpr Real dt = window / 100;
  PressureMeans means;
  Real sum = 0;
  for (int k = 0; k * dt <= until; ++k) {
    const Real t = k * dt, weight = weight_in_window(t - means.begin, window);
    means.weight += weight;
    sum += weight * pressure(t);
    if (t - means.begin >= window * (1 - 1e-9)) {
      end_window(means, sum / means.weight, t);
      sum = 0;
    }
    means.now = mean_now(means, t, window);
  }
  return means;
}

TEST(PressureMeans, swings_of_the_slowest_period_and_its_fractions_vanish)
{
  for (const int fraction : {1, 2, 3, 5, 7})
    for (const Real phase : {0., 1., 2.}) {
      const PressureMeans means = means_of([&](Real t) { return 1 + 0.5 * std::cos(fraction * 2 * M_PI * t + phase); }, 9.99 * window);
      EXPECT_EQ(means.count, 9);
      EXPECT_NEAR(means.largest, 1, 1e-12);
      EXPECT_NEAR(degree_of_consolidation(means), 0, 1e-12);
    }
}

// The sidelobes of the weight are 2.7 % of the amplitude at most.
TEST(PressureMeans, little_is_left_of_faster_swings)
{
  for (Real period = 0.3; period < 1; period += 0.013)
    EXPECT_NEAR(means_of([&](Real t) { return 1 + 0.5 * std::sin(2 * M_PI * t / period); }, 9.99 * window).largest, 1, 0.5 * 0.027)
        << period;
}

// The degree is that of the moment, not of the middle of the last window, and counts from the beginning, not from the first mean; where the pressure falls as the square root of the
// time from there on, as that near a surface that drains does, and where it stays at first, as that at a closed base. Windows of a fourteenth of the time leave 2 %.
TEST(PressureMeans, degree_of_a_pressure_that_falls_is_that_of_the_moment_and_counts_from_the_beginning)
{
  const auto drains = [](Real t) { return 1 - 0.1 * std::sqrt(t); };
  const auto stays = [](Real t) { return std::exp(-std::pow(t / 40, 3)); };
  for (const auto& p : {std::function<Real(Real)>(drains), std::function<Real(Real)>(stays)})
    for (const Real t : {15., 27.7, 42.3}) EXPECT_NEAR(1 - degree_of_consolidation(means_of(p, t)), p(t), 0.02) << t;
}

// A sudden load that damping holds back adds a fifth to the pressure, and is gone in two windows.
TEST(PressureMeans, what_is_left_of_a_sudden_load_is_not_the_largest_pressure)
{
  const auto p = [](Real t) { return 1 + 0.2 * std::exp(-4 * t / window); };
  EXPECT_NEAR(means_of(p, 1.99 * window).largest, 1 + 0.2 * std::exp(-2.), 0.02);
  EXPECT_NEAR(means_of(p, 10 * window).largest, 1, 0.015);
}

TEST(PressureMeans, a_degree_begins_with_the_first_mean)
{
  EXPECT_EQ(degree_of_consolidation(means_of([](Real) { return 1; }, 0.99 * window)), 0);
  EXPECT_EQ(degree_of_consolidation(PressureMeans()), 0);
  EXPECT_EQ(degree_of_consolidation(means_of([](Real t) { return t; }, 5 * window)), 0) << "it grows";
}

TEST(PressureMeans, pressures_without_waves_count_as_they_are)
{
  PressureMeans means;
  for (const Real p : {3., 4., 2., 1.}) note_without_waves(means, p);
  EXPECT_EQ(degree_of_consolidation(means), 0.75);
}

}  // namespace
}  // namespace berm::problem::this_file
