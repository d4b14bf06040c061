// SPDX-License-Identifier: BSD-3-Clause
#include "sea/march.hpp"

#include "macro_element/under_force.hpp"
#include "samples/macro_element_parameters.hpp"

#include <gtest/gtest.h>

namespace berm::sea::this_file {
namespace {

settings::StageSettings in_water(const settings::WaterSettings& water, const std::vector<Real>& times, const std::vector<Real>& velocities)
{
  settings::StageSettings stage;
  stage.kind = settings::StageKind::drag;
  stage.water = water;
  stage.load_times = times;
  stage.loads.of("water") = velocities;
  return stage;
}

/// Soil that resists at once, with the same force wherever the pipe goes on its level.
macro_element::Parameters plain_soil()
{
  macro_element::Parameters soil = macro_element::sample_parameters();
  soil.horizontal_stiffness = soil.vertical_stiffness = 1e8;
  soil.flow_slope = 1e-9;
  soil.first_yield = soil.residual_ratio = 1;
  soil.berm_rate = 0;
  return soil;
}

// m a = F - R: without drag or lift the water gives F = r_y rho pi D^2/4 C_M dU/dt for ever. The elastic displacement, R/k_h = 0.02 mm, and steps of 1/800 of the way are below a thousandth.
TEST(March, of_a_pipe_that_slides_is_that_of_its_mass)
{
  const macro_element::Parameters soil = plain_soil();
  constexpr Real weight = 2000, duration = 1, rate = 5, mass = 500;
  const settings::WaterSettings water{.density = 1025, .inertia = 3, .weight = weight};
  std::vector<Real> times, velocities;
  for (int row = 0; row <= 100; ++row) times.push_back(duration * row / 100), velocities.push_back(rate * times.back());
  const berm_macro_element_state laid = macro_element::laid(soil, 3000, weight);
  const Real R = macro_element::moved_under(soil, laid, 0, 0.1, weight).H;
  const Real F = water_force(water, {0, rate}, soil.diameter, 0, laid.w).H;
  ASSERT_GT(R, 500);
  ASSERT_GT(F, 1.5 * R);
  const Track track = march(soil, laid, in_water(water, times, velocities), mass);
  const Real way = (F - R) / mass * duration * duration / 2;
  EXPECT_NEAR(track.u.back(), way, 2e-3 * way);
  EXPECT_NEAR(track.w.back(), laid.w, 1e-4 * soil.diameter);
}

TEST(March, of_a_pipe_that_the_soil_holds_is_elastic_and_comes_back)
{
  macro_element::Parameters soil = plain_soil();
  soil.horizontal_stiffness = 1e6;
  const settings::WaterSettings water{.density = 1025, .drag = 1, .weight = 2000};
  const Track track = march(soil, macro_element::laid(soil, 3000, 2000), in_water(water, {0, 20, 40}, {0, 1, 0}), 500);
  const Real H = water_force(water, {1, 0}, soil.diameter, 0, track.w[1]).H;
  EXPECT_NEAR(track.u[1], H / 1e6, 1e-3 * H / 1e6);
  EXPECT_NEAR(track.u[2], 0, 1e-3 * H / 1e6);
}

// Rows twice as many make steps half as long; errors are of first order, so the rest is as large as the change.
TEST(March, has_steps_that_are_short_enough)
{
  const macro_element::Parameters soil = macro_element::sample_parameters();
  const settings::WaterSettings water{.density = 1025, .drag = 1, .inertia = 3.29, .lift = 0.9, .weight = 1500};
  const auto end_with = [&](int rows) {
    std::vector<Real> times, velocities;
    for (int row = 0; row <= rows; ++row) {
      times.push_back(60. * row / rows);
      velocities.push_back(0.3 + (1 + 0.02 * times.back()) * std::sin(2 * pi * times.back() / 10));
    }
    return numbers_of(march(soil, macro_element::laid(soil, 1500, 1500), in_water(water, times, velocities), 900), soil.diameter);
  };
  const TrackNumbers coarse = end_with(240), fine = end_with(480);
  EXPECT_GT(fine.half_cycle, 0.1 * soil.diameter) << "it breaks out";
  EXPECT_NEAR(coarse.half_cycle, fine.half_cycle, 0.02 * fine.half_cycle);
  EXPECT_NEAR(coarse.largest, fine.largest, 0.02 * fine.largest);
}

TEST(TrackNumbers, are_those_of_the_turns)
{
  const Track track{{0, 1, 2, 3, 4, 5}, {0.5, 0.7, 0.4, 0.401, 0.4, 0.6}, {0.1, 0.2, 0.15, 0.1, 0.1, 0.1}};
  const TrackNumbers n = numbers_of(track, 0.5);
  EXPECT_NEAR(n.largest, 0.2, 1e-12);
  EXPECT_NEAR(n.half_cycle, 0.3, 1e-12) << "1 mm is no turn";
  EXPECT_NEAR(n.end, 0.1, 1e-12);
  EXPECT_EQ(n.largest_w, 0.2);
}

}  // namespace
}  // namespace berm::sea::this_file
