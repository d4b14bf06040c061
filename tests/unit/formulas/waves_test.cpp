// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/waves.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

TEST(WaveSpectrum, has_the_significant_height_and_for_pierson_and_moskowitz_the_density_of_the_closed_form)
{
  for (const Real peakedness : {1., 3.3, 5.}) EXPECT_NEAR(height_of(WaveSpectrum::jonswap(4, 9, peakedness)), 4, 1e-9);
  const WaveSpectrum sea = WaveSpectrum::jonswap(4, 9, 1);
  const Real peak = 2 * pi / 9;
  EXPECT_DOUBLE_EQ(sea.peak(), peak);
  // S = 5/16 H_s^2 w_p^4 w^-5 exp(-5/4 (w_p/w)^4); beyond 8 w_p lies 5/4 8^-4 = 3e-4 of the variance, which the others have got.
  for (const Real w : {0.7 * peak, peak, 2 * peak})
    EXPECT_NEAR(sea.density(w) / (5. / 16 * 16 * std::pow(peak, 4) * std::pow(w, -5) * std::exp(-1.25 * std::pow(peak / w, 4))), 1, 4e-4);
}

TEST(WaveSpectrum, of_a_table_is_straight_between_rows)
{
  const WaveSpectrum sea = WaveSpectrum::table({0.5, 1, 2}, {0, 4, 0});
  EXPECT_DOUBLE_EQ(sea.density(0.75), 2);
  EXPECT_DOUBLE_EQ(sea.density(1.5), 2);
  EXPECT_DOUBLE_EQ(sea.density(2.1), 0);
  EXPECT_DOUBLE_EQ(sea.peak(), 1);
  EXPECT_NEAR(height_of(sea), 4 * std::sqrt(3.), 1e-6);
}

TEST(WaveNumber, meets_the_dispersion_relation_from_shallow_to_deep)
{
  for (const Real depth : {0.1, 3., 30., 300., 3000.})
    for (const Real w : {0.05, 0.5, 5.}) {
      const Real k = wave_number(w, depth);
      EXPECT_NEAR(standard_gravity * k * std::tanh(k * depth) / (w * w), 1, 1e-12) << depth << " " << w;
    }
}

TEST(WavesAtSeabed, of_shallow_water_are_half_the_height_times_root_g_over_d)
{
  const SeabedWaves waves = waves_at_seabed(WaveSpectrum::jonswap(0.1, 60, 1), 0.5);
  EXPECT_NEAR(waves.velocity, 0.05 * std::sqrt(standard_gravity / 0.5), 0.005 * waves.velocity);  // (k d)^2/6 less at the peak, 1e-4
}

// Adaptive quadrature over the frequency in Hz with another dispersion solver (scipy: quad, brentq): 1.40435 m/s, 10.7314 s; 0.669787 m/s, 9.93185 s.
TEST(WavesAtSeabed, are_those_of_an_independent_quadrature)
{
  const SeabedWaves long_waves = waves_at_seabed(WaveSpectrum::jonswap(3.5, 13, 1), 10.97);
  EXPECT_NEAR(long_waves.velocity, 1.40435, 1e-3);
  EXPECT_NEAR(long_waves.period, 10.7314, 1e-2);
  const SeabedWaves waves = waves_at_seabed(WaveSpectrum::jonswap(4.5, 10, 3.3), 30);
  EXPECT_NEAR(waves.velocity, 0.669787, 5e-4);
  EXPECT_NEAR(waves.period, 9.93185, 5e-3);
}

// The curves of DNV-RP-F109's figure of U_s T_n/H_s over T_n/T_p, as a public calculator has them digitised (docs/formulas.md, J): its points lie 1 % apart.
TEST(WavesAtSeabed, are_those_of_the_curves_of_f109)
{
  const auto reduced = [](Real peakedness, Real ratio) {
    const Real depth = 25, T_n = std::sqrt(depth / standard_gravity);
    return waves_at_seabed(WaveSpectrum::jonswap(2, T_n / ratio, peakedness), depth).velocity * T_n / 2;
  };
  EXPECT_NEAR(reduced(1, 0.102), 0.387, 0.01 * 0.387);
  EXPECT_NEAR(reduced(1, 0.204), 0.189, 0.02 * 0.189);
  EXPECT_NEAR(reduced(3.3, 0.101), 0.404, 0.01 * 0.404);
  EXPECT_NEAR(reduced(3.3, 0.202), 0.208, 0.02 * 0.208);
  EXPECT_NEAR(reduced(5, 0.101), 0.409, 0.01 * 0.409);
  EXPECT_NEAR(reduced(5, 0.202), 0.210, 0.02 * 0.210);
}

TEST(WavePeakedness, is_5_for_steep_seas_and_1_for_swell)
{
  EXPECT_DOUBLE_EQ(wave_peakedness(4, 7.2).value, 5);
  EXPECT_DOUBLE_EQ(wave_peakedness(4, 10).value, 1);
  EXPECT_DOUBLE_EQ(wave_peakedness(4, 8.6).value, std::exp(5.75 - 1.15 * 4.3));
  EXPECT_FALSE(wave_peakedness(0, 8).valid);
}

TEST(WaveDirections, leave_of_the_velocity_the_root_mean_square_of_its_components)
{
  EXPECT_DOUBLE_EQ(wave_direction_factor(pi / 6, infinity), 0.5);
  for (const Real angle : {0., pi / 3, pi / 2})
    for (const Real s : {2., 8.}) {
      Real sum = 0, square = 0;
      constexpr int parts = 20000;
      for (int k = 0; k < parts; ++k) {
        const Real off = (k + 0.5) / parts * pi - pi / 2, density = std::pow(std::cos(off), s);
        sum += density, square += density * std::pow(std::sin(angle + off), 2);
      }
      EXPECT_NEAR(wave_direction_factor(angle, s), std::sqrt(square / sum), 1e-6) << angle << " " << s;
    }
}

TEST(DesignOscillation, is_the_mean_of_the_largest_of_many)
{
  const SeabedWaves waves{.velocity = 1, .period = 10};
  const DesignOscillation found = design_oscillation(waves, 10800, 100, 1);  // T_n/T_u = 0.32
  EXPECT_NEAR(found.velocity.value, 0.5 * (3.73757 + 0.5772 / 3.73757), 1e-5);
  EXPECT_DOUBLE_EQ(found.period.value, 10);
  EXPECT_NEAR(design_oscillation(waves, 10800, 9.80665, 3.3).period.value, 10 * (1.21 - 5 * 0.21 * 0.1), 1e-9);
  EXPECT_TRUE(std::isnan(design_oscillation(waves, 20, 100, 1).velocity.value));
}

TEST(CurrentOnPipe, is_the_mean_of_the_profile_over_its_height)
{
  Real mean = 0;
  constexpr int parts = 200000;
  for (int k = 0; k < parts; ++k) mean += std::log(1 + (k + 0.5) / parts * 0.4 / 1e-4) / std::log(1 + 3 / 1e-4) / parts;
  EXPECT_NEAR(current_on_pipe(0.5, 3, 1e-4, pi / 2, 0.4).value, 0.5 * mean, 1e-6);
  EXPECT_NEAR(current_on_pipe(0.5, 3, 1e-4, pi / 6, 0.4).value, 0.25 * mean, 1e-6);
}

}  // namespace
}  // namespace berm::formulas::this_file
