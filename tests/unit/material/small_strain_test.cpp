// SPDX-License-Identifier: BSD-3-Clause
#include "material/small_strain.hpp"

#include "core/lane_parts.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::material::this_file {
namespace {

constexpr Real gamma_07 = 2e-4;
const SmallStrain law{100, 0.385 / gamma_07};  // G_ur = G_0 / 100 acts nowhere here

/// Soil in triaxial shear at the same mean stress: stress over G_0 under shear strains s1 - s3.
struct Shear {
  Real history[SmallStrain::size] = {};
  Real strain = 0, stress = 0, work = 0;

  void add(Real by)
  {
    // Deviator of s1 - s3 = by.
    const SymTensor<3> e{{-by / 3, 2 * by / 3, -by / 3}};
    const Real change = add_strain(law, history, e, true).mean / law.ratio * by;
    strain += by;
    work += (stress + change / 2) * by;
    stress += change;
  }
  void go_to(Real end, int steps)
  {
    const Real by = (end - strain) / steps;
    for (int k = 0; k < steps; ++k) add(by);
  }
};

Real backbone(Real g)
{
  return g / (1 + 0.385 * g / gamma_07);
}

TEST(SmallStrain, secant_modulus_of_first_loading_is_that_of_hardin_and_drnevich_in_any_number_of_steps)
{
  for (const int steps : {1, 7, 1000})
    for (const Real part : {1e-3, 0.1, 1., 10.}) {
      Shear soil;
      soil.go_to(part * gamma_07, steps);
      EXPECT_NEAR(soil.stress / soil.strain, 1 / (1 + 0.385 * part), 1e-12);
    }
  Shear soil;
  soil.go_to(gamma_07, 1);
  EXPECT_NEAR(soil.stress / soil.strain, 0.722, 1e-4);
}

TEST(SmallStrain, cycles_are_closed_loops_with_the_damping_of_masings_rule)
{
  for (const Real part : {0.3, 1., 5.}) {
    const Real a = part * gamma_07, x = 0.385 * part;
    Shear soil;
    soil.go_to(a, 100);
    for (int cycle = 0; cycle < 3; ++cycle) {
      const Real work = soil.work;
      soil.go_to(-a, 2000);
      EXPECT_NEAR(soil.stress, -backbone(a), 1e-9 * a);
      soil.go_to(a, 2000);
      EXPECT_NEAR(soil.stress, backbone(a), 1e-9 * a);
      // Of a hyperbola: D = 4/pi (1 + 1/x) (1 - log(1 + x) / x) - 2/pi. The work is a sum by trapezia.
      const Real damping = (soil.work - work) / (2 * pi * soil.stress * a);
      EXPECT_NEAR(damping, 4 / pi * (1 + 1 / x) * (1 - std::log(1 + x) / x) - 2 / pi, 1e-5) << part;
    }
    soil.go_to(2 * a, 100);
    EXPECT_NEAR(soil.stress, backbone(2 * a), 1e-3 * a) << "beyond the loop first loading goes on";
  }
}

TEST(SmallStrain, reversal_gives_the_first_stiffness_again)
{
  Shear soil;
  soil.go_to(5 * gamma_07, 100);
  const Shear before = soil;
  soil.add(1e-6 * gamma_07);
  EXPECT_NEAR((soil.stress - before.stress) / (soil.strain - before.strain), 1 / std::pow(1 + 0.385 * 5, 2), 1e-5);
  soil = before;
  soil.add(-1e-6 * gamma_07);
  EXPECT_NEAR((soil.stress - before.stress) / (soil.strain - before.strain), 1, 1e-5);
}

TEST(SmallStrain, small_loops_and_vibration_leave_no_trace_in_first_loading)
{
  Shear smooth, looped, shaken;
  smooth.go_to(3 * gamma_07, 300);
  looped.go_to(gamma_07, 100);
  looped.go_to(0.8 * gamma_07, 20);
  looped.go_to(0.9 * gamma_07, 10);
  looped.go_to(0.85 * gamma_07, 10);
  looped.go_to(3 * gamma_07, 1000);
  EXPECT_NEAR(looped.stress, smooth.stress, 2e-3 * smooth.stress);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> unit(-1, 1);
  for (int k = 0; k < 3000; ++k) shaken.add(gamma_07 * (1e-3 + 2e-2 * unit(random)));
  EXPECT_NEAR(shaken.stress, backbone(shaken.strain), 0.03 * shaken.stress);
}

TEST(SmallStrain, unloading_and_reloading_rejoins_first_loading)
{
  Shear smooth, cycled;
  smooth.go_to(2 * gamma_07, 10);
  cycled.go_to(gamma_07, 10);
  cycled.go_to(-0.2 * gamma_07, 500);
  cycled.go_to(2 * gamma_07, 500);
  EXPECT_NEAR(cycled.stress, smooth.stress, 1e-9 * smooth.stress);
}

TEST(SmallStrain, lanes_and_single_numbers_give_the_same)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> unit(-1, 1);
  Lanes together[SmallStrain::size] = {};
  Real alone[lanes][SmallStrain::size] = {};
  for (int n = 0; n < 20000; ++n) {
    SymTensor<2, Lanes> increments;
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < lanes; ++l) increments[k][l] = gamma_07 * unit(random);
    const Lanes third = trace(increments) * (1. / 3);
    for (int k = 0; k < 3; ++k) increments[k] -= third;
    const Stiffening<Lanes> all = add_strain(law, together, increments, increments[0] <= increments[0]);
    for (int l = 0; l < lanes; ++l) {
      SymTensor<2> increment;
      for (int k = 0; k < 4; ++k) increment[k] = increments[k][l];
      const Stiffening<Real> one = add_strain(law, alone[l], increment, true);
      ASSERT_NEAR(all.mean[l] / one.mean, 1, 1e-9) << n;
      for (int k = 0; k < SmallStrain::size; ++k) alone[l][k] = together[k][l];
    }
  }
}

TEST(SmallStrain, stiffness_is_between_both_limits_for_any_strain)
{
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> unit(-1, 1), decades(-10, 1);
  Real history[SmallStrain::size] = {};
  for (int n = 0; n < 200000; ++n) {
    SymTensor<3> e;
    const Real size = std::pow(10, decades(random));
    for (int k = 0; k < 6; ++k) e[k] = size * unit(random);
    e[2] = -e[0] - e[1];
    const Stiffening<Real> at = add_strain(law, history, e, true);
    ASSERT_TRUE(at.mean >= 1 && at.mean <= law.ratio * (1 + 1e-12)) << n << " " << at.mean;
    ASSERT_TRUE(at.least >= 1 && at.least <= law.ratio);
    if (n % 1000 == 0) std::fill_n(history, SmallStrain::size, 0);
  }
}

TEST(SmallStrain, vibration_in_all_directions_leaves_little_trace)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> unit(-1, 1);
  Real history[SmallStrain::size] = {};
  SymTensor<3> stress, strain;
  for (int k = 0; k < 4000; ++k) {
    SymTensor<3> e;
    for (int i = 0; i < 6; ++i) e[i] = gamma_07 * 5e-3 * unit(random);
    e[3] += gamma_07 * 1e-3;
    const Real mean = trace(e) / 3;
    for (int i = 0; i < 3; ++i) e[i] -= mean;
    const Real modulus = add_strain(law, history, e, true).mean / law.ratio;
    for (int i = 0; i < 6; ++i) strain[i] += e[i], stress[i] += modulus * e[i];
  }
  const Real size = shear_size(strain);
  // 0.96 where every change of direction counts as a reversal.
  EXPECT_NEAR(stress[3] / strain[3], backbone(size) / size, 0.02);
}

}  // namespace
}  // namespace berm::material::this_file
