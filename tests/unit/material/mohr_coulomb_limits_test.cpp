// SPDX-License-Identifier: BSD-3-Clause
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// Strains a particle under a constant stress in x or y: the free strain that keeps it is found from the elastic response, corrected until it holds.
SymTensor<2> load_in_plane_strain(const PreparedMohrCoulomb& law, Real start, Real increment, int steps)
{
  SymTensor<2> stress{{start, start, start, 0}};
  Real opening = 0;
  for (int step = 0; step < steps; ++step) {
    SymTensor<2> strain{{increment, 0, 0, 0}}, next = stress;
    for (int correction = 0; correction < 200; ++correction) {
      next = stress;
      Real next_opening = opening;
      update(law, next, {strain}, &next_opening);
      const Real error = next[1] - start;
      if (std::abs(error) < 1e-9 * std::abs(start)) break;
      strain[1] -= error / p_wave_modulus(law.elastic);
    }
    stress = next;
  }
  return stress;
}

TEST(MohrCoulomb, plane_strain_compression_reaches_the_passive_limit)
{
  // s3 = Kp s1 - 2 c sqrt(Kp), compression negative; the correction of the free strain holds s1 to 1e-9.
  for (const Real dilation : {0., 15.}) {
    const MohrCoulomb law = soil(5e3, 35, dilation);
    const Real passive = (1 + std::sin(law.friction_angle)) / (1 - std::sin(law.friction_angle));
    const SymTensor<2> stress = load_in_plane_strain(prepare(law), -1e5, -1e-4, 1000);
    EXPECT_NEAR(stress[0], -1e5 * passive - 2 * 5e3 * std::sqrt(passive), 1e-7 * 1e5 * passive);
  }
}

TEST(MohrCoulomb, plane_strain_extension_reaches_the_active_limit)
{
  const MohrCoulomb law = soil(0, 35, 0);
  const Real active = (1 - std::sin(law.friction_angle)) / (1 + std::sin(law.friction_angle));
  const SymTensor<2> stress = load_in_plane_strain(prepare(law), -1e5, 1e-4, 1000);
  EXPECT_NEAR(stress[0], -1e5 * active, 1e-7 * 1e5);
}

TEST(MohrCoulomb, triaxial_compression_ends_on_the_edge)
{
  // Axis x is compressed at constant mean stress p: s1 = s2 on the edge, and s3 = p - 2 q/3, s1 = p + q/3 with q = 6 (c cos phi - p sin phi) / (3 - sin phi).
  const MohrCoulomb law = soil(1e4, 30, 0);
  const Real p = -1e5, q = 6 * (1e4 * std::cos(law.friction_angle) - p * std::sin(law.friction_angle)) / (3 - std::sin(law.friction_angle));
  SymTensor<3> stress{{p, p, p, 0, 0, 0}};
  Real opening = 0;
  for (int step = 0; step < 100; ++step) update(prepare(law), stress, {{-2e-3, 1e-3, 1e-3, 0, 0, 0}}, &opening);
  EXPECT_NEAR(stress[0], p - 2 * q / 3, 1e-6);
  EXPECT_NEAR(stress[1], p + q / 3, 1e-6);
  EXPECT_NEAR(stress[2], p + q / 3, 1e-6);
}

TEST(MohrCoulomb, without_friction_it_is_tresca)
{
  const Real strength = 3e3;
  const PreparedMohrCoulomb law = prepare(soil(strength, 0, 0));
  std::mt19937_64 random(7);
  for (int n = 0; n < 10000; ++n) {
    const SymTensor<2> trial = random_trial<2>(random), stress = returned(law, trial);
    if (yield_value(law, trial) <= 0) continue;
    const Real mean = (stress[0] + stress[1]) / 2, radius = std::hypot((stress[0] - stress[1]) / 2, stress[3]);
    const Real largest = std::max(mean + radius, stress[2]), smallest = std::min(mean - radius, stress[2]);
    // Rounding of stresses of the trial's size.
    EXPECT_NEAR((largest - smallest) / 2, strength, 1e-13 * size_of(trial) + 1e-10 * strength);
    EXPECT_NEAR(trace(stress), trace(trial), 1e-13 * size_of(trial));
  }
}

TEST(MohrCoulomb, tresca_holds_its_strength_under_any_mean_stress)
{
  const PreparedMohrCoulomb law = prepare(soil(3e3, 0, 0));
  for (const Real mean : {-1e6, 0., 1e6}) {
    const SymTensor<2> stress = returned<2>(law, {{mean, mean, mean, 5e3}});
    EXPECT_NEAR(stress[3], 3e3, 1e-9);
    EXPECT_NEAR(stress[0], mean, 1e-9);
  }
}

TEST(MohrCoulomb, plastic_volume_follows_plastic_shear_with_the_sine_of_the_dilation_angle)
{
  for (const Real dilation : {0., 10., 35.}) {
    const MohrCoulomb law = soil(1e3, 35, dilation);
    const PreparedMohrCoulomb prepared = prepare(law);
    const SymTensor<2> trial{{-1e5, -1e5, -1e5, 7e4}};
    const SymTensor<2> plastic = elastic_strain(prepared.elastic, difference(trial, returned(prepared, trial)));
    // On the face of s1 and s3, here in the plane: e1 + e3 = (e1 - e3) sin psi.
    const Real shear = 2 * std::hypot((plastic[0] - plastic[1]) / 2, plastic[3]);
    EXPECT_GT(shear, 1e-3);
    EXPECT_NEAR(trace(plastic) / shear, std::sin(law.dilation_angle), 1e-12);
    EXPECT_NEAR(plastic[2], 0, 1e-12 * shear);
  }
}

TEST(MohrCoulomb, tension_ends_at_the_cut_off)
{
  const PreparedMohrCoulomb law = prepare(soil(1e4, 30, 0, 2e3));
  const SymTensor<2> pulled = returned<2>(law, {{5e3, -8e3, -1e3, 0}});
  EXPECT_NEAR(pulled[0], 2e3, 1e-9);
  EXPECT_LT(pulled[1], -8e3);
  const SymTensor<2> corner = returned<2>(law, {{5e4, 4e4, 4.5e4, 1e3}});
  for (int k = 0; k < 3; ++k) EXPECT_EQ(corner[k], 2e3);
  EXPECT_EQ(corner[3], 0);
}

TEST(MohrCoulomb, a_cut_off_above_the_apex_does_nothing)
{
  const PreparedMohrCoulomb with = prepare(soil(1e4, 30, 0, 1e5)), without = prepare(soil(1e4, 30, 0));
  std::mt19937_64 random(8);
  for (int n = 0; n < 1000; ++n) {
    const SymTensor<2> trial = random_trial<2>(random), a = returned(with, trial), b = returned(without, trial);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(a[k], b[k]);
  }
}

TEST(MohrCoulomb, no_stress_and_no_strength_and_huge_strains_give_numbers)
{
  std::vector<MohrCoulomb> laws = soils();
  laws.push_back(soil(0, 0, 0));
  laws.push_back(soil(0, 0, 0, 0.));
  laws.push_back(soil(0, 1e-9, 0));
  for (const MohrCoulomb& law : laws) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (const Real size : {0., 1e-300, 1e-30, 1., 1e6, 1e30})
      for (const SymTensor<2>& pattern :
           {SymTensor<2>{{1, 1, 1, 0}}, {{-1, -1, -1, 0}}, {{1, -1, 0, 0}}, {{0, 0, 0, 1}}, {{3, 1, -2, 5}}}) {
        SymTensor<2> strain, stress;
        for (int k = 0; k < 4; ++k) strain[k] = size * pattern[k];
        Real opening = 0;
        for (int step = 0; step < 3; ++step) {
          update(prepared, stress, {strain}, &opening);
          for (int k = 0; k < 4; ++k) ASSERT_TRUE(std::isfinite(stress[k]));
          ASSERT_TRUE(opening >= 0 && opening <= law.max_opening);
          // Rounding of the trial, which is a few times size x modulus. The square of a stress below 1e-154 Pa is zero.
          ASSERT_LE(yield_value(prepared, stress), 1e-150 + 1e-12 * (law.cohesion + size * p_wave_modulus(prepared.elastic)));
        }
      }
  }
}

TEST(MohrCoulomb, soil_without_strength_is_a_fluid)
{
  const PreparedMohrCoulomb law = prepare(soil(0, 0, 0));
  const SymTensor<2> stress = returned<2>(law, {{-3e3, -1e3, -8e3, 2e3}});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], -4e3, 1e-9);
  EXPECT_NEAR(stress[3], 0, 1e-9);
}

}  // namespace
}  // namespace berm::material::this_file
