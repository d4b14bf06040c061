// SPDX-License-Identifier: BSD-3-Clause
#include "material/norsand.hpp"

#include "critical_state_paths.hpp"
#include "material/material.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5, slope = 1.25, gamma = 0.9, lambda = 0.03;

Element<NorSand> triaxial(Real state_parameter)
{
  return {sample_norsand(state_parameter), isotropic(p0)};
}

Real psi_of(const Element<NorSand>& soil, Real pressure)
{
  return soil.state[1] - gamma + lambda * std::log(pressure / 1e3);
}

/// M_i of the present image pressure and void ratio, by the formula.
Real image_slope(const Element<NorSand>& soil)
{
  const Real chi = 3.5 / (1 - 3.5 * lambda / slope);
  return slope * (1 - 0.3 * chi * std::abs(psi_of(soil, soil.state[0])) / slope);
}

/// D_min = chi_i psi_i with the M_i of the moment.
Real least_dilatancy(const Element<NorSand>& soil)
{
  return 3.5 / (1 - 3.5 * lambda / image_slope(soil)) * psi_of(soil, soil.state[0]);
}

TEST(NorSand, begins_with_the_state_of_its_stress)
{
  const Element<NorSand> soil = triaxial(-0.1);
  EXPECT_NEAR(psi_of(soil, p0), -0.1, 1e-12);
  EXPECT_NEAR(soil.state[0], p0 / std::exp(1), 1e-6 * p0) << "the tip of the surface, where eta = 0";

  NorSand law = sample_norsand();
  law.state_parameter = {};
  law.void_ratio = 0.7;
  const Element<NorSand> k0(law, {{-0.5e5, -1e5, -0.5e5}});
  EXPECT_EQ(k0.state[1], 0.7);
  EXPECT_NEAR(k0.ratio(), image_slope(k0) * (1 + std::log(k0.state[0] / k0.pressure())), 1e-9) << "on the surface";
  law.overconsolidation_ratio = 2;
  const Element<NorSand> past(law, {{-0.5e5, -1e5, -0.5e5}});
  EXPECT_NEAR(past.ratio(), image_slope(past) * (1 + std::log(past.state[0] / 2 / past.pressure())), 1e-9);
}

TEST(NorSand, undrained_sand_ends_on_the_critical_state_line_at_its_void_ratio)
{
  for (const Real psi : {0.08, 0.03, -0.03, -0.1})
    for (const int steps : {20, 1000}) {
      Element<NorSand> soil = triaxial(psi);
      const Real void_ratio = soil.state[1], end = 1e3 * std::exp((gamma - void_ratio) / lambda);
      shear_undrained(soil, 2, steps);
      EXPECT_NEAR(soil.state[1], void_ratio, 1e-12);
      // The path comes to its end exponentially; what is left at a strain of 200 % is less than a thousandth.
      EXPECT_NEAR(soil.pressure() / end, 1, 1e-3) << psi << " " << steps;
      EXPECT_NEAR(soil.ratio(), slope, 1e-3);
    }
}

TEST(NorSand, loose_sand_softens_undrained_and_dense_sand_passes_the_image_state)
{
  Element<NorSand> loose = triaxial(0.08), dense = triaxial(-0.1);
  Real peak = 0, least = infinity, ratio_at_least = 0;
  for (int k = 0; k < 5000; ++k) {
    shear_undrained(loose, 1e-4, 1);
    shear_undrained(dense, 1e-4, 1);
    peak = std::max(peak, loose.q());
    if (dense.pressure() < least) least = dense.pressure(), ratio_at_least = dense.ratio();
  }
  EXPECT_LT(loose.q(), 0.3 * peak);
  EXPECT_LT(least, 0.8 * p0) << "contracts first,";
  EXPECT_GT(dense.pressure(), 2 * p0) << "dilates afterwards,";
  EXPECT_NEAR(ratio_at_least, image_slope(triaxial(-0.1)), 0.05 * slope) << "and turns at the image state, eta = M_i";
}

TEST(NorSand, plastic_dilatancy_is_the_image_ratio_less_the_stress_ratio)
{
  for (const Real psi : {0.05, -0.1}) {
    Element<NorSand> soil = triaxial(psi);
    for (int k = 0; k < 300; ++k) {
      const Element<NorSand> before = soil;
      constexpr Real axial = 1e-4;
      shear_drained(soil, axial);
      const Real pressure = std::sqrt(soil.pressure() * before.pressure()), shear = 300 * pressure;
      const Real bulk = shear / shear_over_bulk(0.2), volumetric = soil.volumetric - before.volumetric;
      const Real plastic_volume = volumetric - (soil.pressure() - before.pressure()) / bulk;
      const Real deviatoric = axial - volumetric / 3, plastic_shear = deviatoric - (soil.q() - before.q()) / (3 * shear);
      // Differences of small increments.
      if (k > 5) {
        ASSERT_NEAR(plastic_volume / plastic_shear, image_slope(soil) - soil.ratio(), 2e-3) << psi << " " << k;
      }
    }
  }
}

TEST(NorSand, drained_peak_is_that_of_the_least_dilatancy)
{
  for (const Real psi : {-0.05, -0.1, -0.15}) {
    Element<NorSand> soil = triaxial(psi);
    Real peak = 0, limit = 0, closest = infinity;
    for (int k = 0; k < 4000; ++k) {
      shear_drained(soil, 1e-4);
      const Real here = image_slope(soil) - least_dilatancy(soil);
      ASSERT_LE(soil.ratio(), (image_slope(soil) - 3.5 * psi_of(soil, soil.pressure())) * (1 + 1e-6)) << "never beyond eta_max";
      if (soil.ratio() > peak) peak = soil.ratio(), limit = here;
      closest = std::min(closest, here - soil.ratio());
    }
    // Hardening with H = 150 comes near the limit, which itself moves while the sand dilates.
    EXPECT_NEAR(peak / limit, 1, 0.02) << psi;
    EXPECT_LT(closest, 0.01 * limit);
    EXPECT_GT(peak, slope * 1.05);
  }
}

TEST(NorSand, drained_sand_ends_at_the_critical_state)
{
  for (const Real psi : {0.05, -0.1}) {
    Element<NorSand> soil = triaxial(psi);
    for (int k = 0; k < 1500; ++k) shear_drained(soil, 1e-3);
    EXPECT_NEAR(soil.ratio(), slope, 2e-3 * slope) << psi;
    EXPECT_NEAR(psi_of(soil, soil.pressure()), 0, 2e-3);
    EXPECT_NEAR(soil.state[1], (1 + triaxial(psi).state[1]) * std::exp(-soil.volumetric) - 1, 1e-9) << "e follows the volume";
  }
}

TEST(NorSand, unloaded_sand_has_no_more_than_its_peak_strength)
{
  Element<NorSand> soil = triaxial(-0.1);
  for (int k = 0; k < 50; ++k) soil.compress(-1e-4, -1e-4);
  EXPECT_LT(soil.pressure(), p0 / 5) << "unloaded";
  Real peak = 0;
  for (int k = 0; k < 500; ++k) {
    shear_drained(soil, 1e-4);
    // eta_max = M_i - chi_tc psi at the pressure of the moment.
    ASSERT_LE(soil.ratio(), (image_slope(soil) - 3.5 * psi_of(soil, soil.pressure())) * (1 + 1e-6));
    peak = std::max(peak, soil.ratio());
  }
  EXPECT_GT(peak, slope);
}

TEST(NorSand, isotropic_compression_keeps_to_the_tip_of_the_surface)
{
  Element<NorSand> soil = triaxial(0);
  for (int k = 0; k < 100; ++k) soil.compress(1e-4, 1e-4);
  EXPECT_GT(soil.pressure(), 1.5 * p0);
  EXPECT_NEAR(soil.state[0] * std::exp(1), soil.pressure(), 1e-6 * soil.pressure());
  EXPECT_NEAR(soil.q(), 0, 1e-6);
  const Real elastic = p0 * std::exp(0.03 * 300 / shear_over_bulk(0.2));
  EXPECT_LT(soil.pressure(), elastic) << "softer than without flow";
}

TEST(NorSand, soil_that_parts_carries_the_minimum_pressure)
{
  Element<NorSand> soil = triaxial(-0.1);
  for (int k = 0; k < 20; ++k) soil.compress(-0.05, -0.02);
  EXPECT_NEAR(soil.pressure(), soil.law.min_pressure, 1e-9 * soil.law.min_pressure);
  EXPECT_LE(soil.ratio(), 2 * slope);
  soil.compress(0.001, 0.001);
  EXPECT_GT(soil.pressure(), soil.law.min_pressure);
}

TEST(NorSand, stress_ends_on_or_inside_the_surface_for_any_increment)
{
  std::mt19937_64 random(29);
  std::uniform_real_distribution<Real> ratio(1, 20), psi(-0.25, 0.15);
  int at_yield = 0;
  for (int n = 0; n < 4000; ++n) {
    NorSand law = sample_norsand(psi(random));
    law.overconsolidation_ratio = n % 2 == 0 ? 1 : ratio(random);
    law.max_pressure = n % 3 == 0 ? 1e5 : 1e8;
    law.hardening_slope = n % 5 == 0 ? 500 : 0;
    Element<NorSand> soil(law, random_stress<3>(random, 1.5));
    for (int k = 0; k < 10; ++k) {
      update(soil.prepared, soil.stress, Increment<3, Real>{random_strain<3>(random, 2)}, soil.state);
      const ImageState<Real> s = image_state(soil.prepared, soil.state[1], std::log(soil.pressure()), std::log(soil.state[0]));
      const Real f = soil.ratio() - s.slope * (1 + s.below);
      ASSERT_TRUE(std::isfinite(f)) << n << " " << k;
      // The tip is a corner: there the image pressure follows within the rounding of p'.
      ASSERT_LE(f, 1e-7) << n << " " << k;
      ASSERT_GE(soil.pressure(), law.min_pressure * (1 - 1e-9));
      at_yield += f > -1e-7;
    }
  }
  EXPECT_GT(at_yield, 4000);
}

TEST(NorSand, lanes_and_single_numbers_give_the_same_stress)
{
  expect_lanes_like_single_numbers(sample_norsand(), 1.4);
}

TEST(NorSand, tangent_is_that_of_finite_differences)
{
  expect_tangent_of_differences(sample_norsand(-0.05), 1.2, 2e-3);
}

TEST(NorSand, is_never_stiffer_than_the_time_step_is_made_for)
{
  NorSand law = sample_norsand();
  law.max_pressure = 1e4;
  // With its dilatancy bounded the flow is not normal to the surface, and a law whose flow is not may work more than its elasticity. The time step has a tenth
  // of the frequency in hand, a fifth of the stiffness; a twentieth of that is asked for.
  expect_no_stiffness_beyond_that_of_the_time_step(law, 1, 0.01);
}

TEST(NorSand, answers_the_queries)
{
  const NorSand law = sample_norsand();
  const Material soil = law;
  EXPECT_EQ(law_name(soil), "NorSand");
  ASSERT_EQ(state_fields(soil).size(), 2u);
  EXPECT_EQ(state_fields(soil)[0].unit, "Pa");
  EXPECT_EQ(state_fields(soil)[1].name, "void_ratio");
  EXPECT_TRUE(yields(soil));
  EXPECT_FALSE(strength_at_rest(soil));
  EXPECT_NEAR(elasticity(soil).shear, 300 * law.max_pressure, 1);
  EXPECT_NEAR(young_poisson(soil).young_modulus, 2 * 1.2 * 300 * law.max_pressure, 1e3);
  EXPECT_EQ(young_poisson(soil).poisson_ratio, 0.2);
}

}  // namespace
}  // namespace berm::material::this_file
