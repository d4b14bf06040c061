// SPDX-License-Identifier: BSD-3-Clause
#include "sample_sea.hpp"
#include "sea/record.hpp"

#include <gtest/gtest.h>

namespace berm::sea::this_file {
namespace {

Real mean_of(const std::vector<Real>& values)
{
  Real sum = 0;
  for (const Real value : values) sum += value;
  return sum / static_cast<Real>(values.size());
}

/// About a known mean.
Real variance_about(Real mean, const std::vector<Real>& values)
{
  Real sum = 0;
  for (const Real value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<Real>(values.size());
}

/// Variances of the velocity and the acceleration at the seabed, by the spectrum.
std::pair<Real, Real> variances(const SeaCase& c)
{
  const formulas::SeabedWaves waves = formulas::waves_at_seabed(*c.spectrum, c.sea.depth);
  const Real velocity = waves.velocity * waves.velocity / 4;
  return {velocity, velocity * std::pow(2 * pi / waves.period, 2)};
}

// A realisation of an hour has as many independent numbers as the velocity has bandwidth times duration, 0.03 Hz x 3600 s = 110. 9000 of them: 970000, so that a variance
// has a standard error of sqrt(2/970000) = 0.14 %, a fourth moment one of sqrt(96/970000)/3 = 0.33 %: 1 % is three of the latter.
TEST(Realisation, has_the_variances_of_the_spectrum_and_the_forces_of_morison)
{
  SeaCase c = sample_sea();
  c.record.step = 33;  // rows need not follow the waves
  constexpr int seeds = 9000;
  constexpr Real current = 0.3;
  Real velocity = 0, acceleration = 0, H = 0, H_without = 0, V = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const LoadRecord record = realisation(c, {.current = current}, seed);
    velocity += variance_about(current, record.velocity) / seeds;
    acceleration += variance_about(0, record.acceleration) / seeds;
    V += mean_of(record.V) / seeds;
    H += mean_of(record.H) / seeds;
    H_without += variance_about(0, realisation(c, {}, seed).H) / seeds;
  }
  const auto [velocity_by, acceleration_by] = variances(c);
  EXPECT_NEAR(velocity / velocity_by, 1, 0.01);
  EXPECT_NEAR(acceleration / acceleration_by, 1, 0.01);
  // Borgman 1967: without a current H has the variance 3 k_d^2 s_u^4 + k_m^2 s_a^2.
  const Real drag = 1025 * 0.25 / 2 * 0.9, mass = 1025 * pi * 0.25 * 0.25 / 4 * 3.29;
  EXPECT_NEAR(H_without / (3 * std::pow(drag * velocity_by, 2) + mass * mass * acceleration_by), 1, 0.01);
  EXPECT_NEAR((400 - V) / (0.7 * 1025 * 0.25 / 2 * 1.1 * (velocity_by + current * current)), 1, 0.01);
  // E|u|u of a normal u of mean m: (m^2 + s^2)(2 Phi(m/s) - 1) + 2 m s phi(m/s).
  const Real s = std::sqrt(velocity_by), x = current / s, density = std::exp(-x * x / 2) / std::sqrt(2 * pi);
  EXPECT_NEAR(H / (drag * ((current * current + s * s) * std::erf(x / std::sqrt(2.)) + 2 * current * s * density)), 1, 0.01);
}

// Of N oscillations of a narrow band: the standard deviation of the largest is pi/sqrt(6)/sqrt(2 ln N) = 0.4 s_u of 3.6 s_u; of the mean of 60, 1.4 %.
TEST(Realisation, has_its_largest_velocity_as_the_design_oscillation)
{
  SeaCase c = sample_sea();
  constexpr int seeds = 60;
  Real largest = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const LoadRecord record = realisation(c, {}, seed);
    largest += *std::max_element(record.velocity.begin(), record.velocity.end()) / seeds;
  }
  const formulas::SeabedWaves waves = formulas::waves_at_seabed(*c.spectrum, c.sea.depth);
  EXPECT_NEAR(largest / formulas::design_oscillation(waves, 3600, 30, 3.3).velocity.value, 1, 0.045);
}

TEST(Realisation, has_the_acceleration_that_its_velocity_has)
{
  SeaCase c = sample_sea();
  c.record.step = 0.05;
  c.sea.duration = 300;
  const LoadRecord record = realisation(c, {.direction = 0.5}, 4);
  Real largest = 0, off = 0;
  for (std::size_t row = 1; row + 1 < record.velocity.size(); ++row) {
    largest = std::max(largest, std::abs(record.acceleration[row]));
    off = std::max(off, std::abs((record.velocity[row + 1] - record.velocity[row - 1]) / 0.1 - record.acceleration[row]));
  }
  EXPECT_LT(off, 1e-3 * largest);  // (w dt)^2/6 of waves to 3 rad/s: 4e-3 at worst, 2e-4 at the peak
}

TEST(Realisation, is_the_same_for_the_same_seed_and_another_for_another)
{
  const SeaCase c = sample_sea();
  EXPECT_EQ(realisation(c, {}, 1).H, realisation(c, {}, 1).H);
  EXPECT_NE(realisation(c, {}, 1).H, realisation(c, {}, 2).H);
}

TEST(Waves, go_from_one_crossing_of_the_mean_to_the_next)
{
  LoadRecord record;
  record.step = 1;
  record.velocity = record.H = {-1, 2, 1, -1, -3, 1, 5, -4, 2};
  const std::vector<LoadWave> waves = waves_of(record);  // mean 0.22
  ASSERT_EQ(waves.size(), 2u);
  EXPECT_EQ(waves[0].begin, 1u);
  EXPECT_EQ(waves[0].end, 5u);
  EXPECT_EQ(waves[0].crest, 2);
  EXPECT_EQ(waves[0].trough, -3);
  EXPECT_EQ(waves[1].size(), 5);
}

TEST(LargestWaves, come_in_their_order_in_time)
{
  const auto wave = [](std::size_t begin, Real crest) { return LoadWave{begin, begin + 1, crest, 0}; };
  const std::vector<LoadWave> largest = largest_waves({wave(0, 3), wave(1, 1), wave(2, 5), wave(3, 2)}, 3);
  ASSERT_EQ(largest.size(), 3u);
  EXPECT_EQ(largest[0].crest, 3);
  EXPECT_EQ(largest[1].crest, 5);
  EXPECT_EQ(largest[2].crest, 2);
  EXPECT_EQ(largest_waves({wave(0, 3)}, 3).size(), 1u);
}

}  // namespace
}  // namespace berm::sea::this_file
