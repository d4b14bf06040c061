// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/motion.hpp"

#include <gtest/gtest.h>

namespace berm::boundary::this_file {
namespace {

MotionSettings motion_of(std::vector<Real> times, std::vector<Real> along_y)
{
  MotionSettings motion;
  motion.times = std::move(times);
  motion.velocity[1] = std::move(along_y);
  return motion;
}

TEST(Motion, is_linear_between_its_rows_and_constant_after)
{
  const MotionSettings motion = motion_of({0, 1, 3}, {2, 4, 0});
  for (const auto& [time, velocity] : {std::pair{0., 2.}, {0.5, 3.}, {1., 4.}, {2., 2.}, {3., 0.}, {9., 0.}})
    EXPECT_EQ(velocity_at(motion, 1, time), velocity) << time;
  EXPECT_EQ(velocity_at(motion, 0, 0.5), 0) << "it moves along y alone";
}

// Up by 1 m with a turn of the displacement within a row, then back: 0.5 (1 + 1) - 0.5 (1 + 1).
TEST(Motion, tells_its_travel_and_what_is_left_of_it)
{
  const MotionMeasures whole = measures_of(motion_of({0, 1, 3, 4}, {0, 1, -1, 0}), 1, 10);
  EXPECT_EQ(whole.speed, 1);
  EXPECT_NEAR(whole.excursion, 1, 1e-15) << "where the velocity is 0, at 2 s";
  EXPECT_NEAR(whole.residual, 0, 1e-15);
  EXPECT_EQ(whole.last, 0);
  const MotionMeasures cut = measures_of(motion_of({0, 1, 3, 4}, {0, 1, -1, 0}), 1, 2.5);
  EXPECT_NEAR(cut.residual, 0.875, 1e-15);
  EXPECT_EQ(cut.last, -0.5);
}

TEST(Motion, tells_its_shortest_half_wave)
{
  EXPECT_EQ(measures_of(motion_of({0, 1, 3, 4}, {0, 1, -1, 0}), 1, 10).half_wave, 2) << "from rest to a turning point is a quarter";
  EXPECT_EQ(measures_of(motion_of({0, 1, 2, 3, 4}, {0, 0.5, 1, 1, 0}), 1, 10).half_wave, 1)
      << "a level part ends one: two rows up, one down";
  EXPECT_EQ(measures_of(motion_of({0, 1, 1.1, 1.2, 3}, {0, 1, 0.95, 1, 0}), 1, 10).half_wave, 2)
      << "a twentieth of the speed does not count";
  EXPECT_NEAR(measures_of(motion_of({0, 1, 1.1, 1.2, 3}, {0, 1, 0.5, 1, 0}), 1, 10).half_wave, 0.1, 1e-15);
  EXPECT_EQ(measures_of(motion_of({0, 1}, {1, 0}), 1, 10).half_wave, 0) << "it begins with a jump";
}

// Sines begin and end in the middle of a wave, pulses of 1 - cos level, at its trough.
TEST(Motion, that_begins_or_ends_at_rest_has_the_half_wave_of_its_period)
{
  constexpr Real frequency = 2.5, period = 1 / frequency;
  const auto half_wave = [&](auto value, Real periods) {
    std::vector<Real> times, values;
    for (int k = 0; k <= 400; ++k) {
      times.push_back(periods * period * k / 400);
      values.push_back(value(2 * pi * frequency * times.back()));
    }
    return measures_of(motion_of(times, values), 1, 10).half_wave;
  };
  const auto sine = [](Real x) { return 0.1 * std::sin(x); };
  constexpr Real rows = 2 * period / 400;  // turning points are those of rows
  for (const Real periods : {0.5, 1., 2., 1.25}) EXPECT_NEAR(half_wave(sine, periods), period / 2, 4 * periods * rows) << periods;
  EXPECT_NEAR(half_wave([](Real x) { return 0.1 * (1 - std::cos(x)); }, 1), period / 2, rows);
  EXPECT_NEAR(half_wave([](Real x) { return 0.1 * std::sin(x) * (x < pi ? 1 : 0); }, 1), period / 2, 2 * rows) << "half a sine, then rest";
}

}  // namespace
}  // namespace berm::boundary::this_file
