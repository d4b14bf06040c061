// SPDX-License-Identifier: BSD-3-Clause
#include "material/modified_cam_clay.hpp"

#include "critical_state_paths.hpp"
#include "material/material.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5;

/// Soil under p0 whose isotropic p_c is R p0.
Element<ModifiedCamClay> triaxial(Real R, Real slope = 1)
{
  Element<ModifiedCamClay> soil(sample_cam_clay(slope), isotropic(p0));
  soil.state[0] = R * p0;
  return soil;
}

// p', p_c and the surface are exact at the end of an increment of any size: only how near the path comes to its end is left.
constexpr Real accuracy = 1e-4;

TEST(ModifiedCamClay, undrained_triaxial_strength_is_that_of_the_closed_form_with_few_or_many_increments)
{
  for (const auto& [R, strength, excess] : {std::tuple{1., 57.43e3, 61.71e3}, {2., 100e3, 33.33e3}, {4., 174.11e3, -16.07e3}})
    for (const int steps : {5, 100, 2000}) {
      Element<ModifiedCamClay> soil = triaxial(R);
      shear_undrained(soil, 0.5, steps);
      EXPECT_NEAR(soil.pressure(), strength, accuracy * strength) << R << " " << steps;
      EXPECT_NEAR(soil.q(), strength, accuracy * strength);
      EXPECT_NEAR(soil.pressure(), p0 * std::pow(R / 2, 0.8), 1e-6 * p0) << "p_f' = p0' (R/2)^L";
      // The total mean stress grows by q / 3 where the cell pressure is held.
      EXPECT_NEAR(p0 + soil.q() / 3 - soil.pressure(), excess, 1e-3 * p0);
    }
}

TEST(ModifiedCamClay, undrained_path_is_that_of_the_closed_form)
{
  constexpr std::array<std::pair<Real, Real>, 4> path = {{{0.2, 0.9691}, {0.4, 0.8880}, {0.6, 0.7819}, {0.8, 0.6732}}};
  Element<ModifiedCamClay> soil = triaxial(1), before = soil;
  for (const auto& [ratio, expected] : path) {
    while (soil.ratio() < ratio) {
      before = soil;
      shear_undrained(soil, 1e-5, 1);
    }
    const Real part = (ratio - before.ratio()) / (soil.ratio() - before.ratio());
    EXPECT_NEAR(std::lerp(before.pressure(), soil.pressure(), part) / p0, expected, 1e-4) << "four digits are given";
  }
}

TEST(ModifiedCamClay, drained_triaxial_test_ends_at_the_critical_state_and_its_volume)
{
  for (const int steps : {20, 200}) {
    Element<ModifiedCamClay> soil = triaxial(1);
    for (int k = 0; k < steps; ++k) shear_drained(soil, 1.5 / steps);
    EXPECT_NEAR(soil.pressure(), 150e3, 1e-3 * 150e3);
    EXPECT_NEAR(soil.q(), 150e3, 1e-3 * 150e3);
    EXPECT_NEAR(soil.volumetric, 0.0960, 1e-3 * 0.0960);
  }
}

TEST(ModifiedCamClay, virgin_compression_follows_the_line_and_k0_of_the_law)
{
  for (const auto& [slope, k0] : {std::pair{0.9, 0.761}, {1., 0.722}, {1.2, 0.648}}) {
    EXPECT_NEAR(virgin_k0(sample_cam_clay(slope)), k0, 5e-4) << "three digits are given";
    for (const int steps : {10, 1000}) {
      Element<ModifiedCamClay> soil = triaxial(1, slope);
      for (int k = 0; k < steps; ++k) soil.compress(0.2 / steps, 0);
      EXPECT_NEAR(soil.stress[0] / soil.stress[1], virgin_k0(soil.law), 1e-4);
      const Real vertical = soil.stress[1];
      for (int k = 0; k < steps; ++k) soil.compress(0.1 / steps, 0);
      EXPECT_NEAR(std::log(soil.stress[1] / vertical) * 0.2 / 2, 0.1, 1e-6) << "strain = lambda / v0 log(stress)";
    }
  }
}

TEST(ModifiedCamClay, undrained_plane_strain_strength_has_no_lode_angle)
{
  for (const int steps : {20, 500}) {
    const PreparedModifiedCamClay law = prepare(sample_cam_clay());
    SymTensor<2> stress{{-p0, -p0, -p0, 0}};
    Real consolidation = p0;
    for (int k = 0; k < steps; ++k) update(law, stress, Increment<2, Real>{{{0.3 / steps, -0.3 / steps, 0, 0}}}, &consolidation);
    EXPECT_NEAR((stress[0] - stress[1]) / 2, 33.16e3, 1e-3 * 33.16e3);
  }
}

TEST(ModifiedCamClay, swelling_and_reloading_keep_to_their_line_in_increments_of_any_size)
{
  for (const int steps : {1, 7, 100}) {
    Element<ModifiedCamClay> soil = triaxial(5);
    for (int k = 0; k < steps; ++k) soil.compress(0.01 / steps, 0.01 / steps);
    EXPECT_NEAR(soil.pressure(), p0 * std::exp(0.03 / 0.02), 1e-9 * p0);
    for (int k = 0; k < steps; ++k) soil.compress(-0.015 / steps, -0.015 / steps);
    EXPECT_NEAR(soil.pressure(), p0 * std::exp(-0.015 / 0.02), 1e-9 * p0);
    EXPECT_EQ(soil.state[0], 5 * p0);
  }
}

TEST(ModifiedCamClay, shear_stiffness_follows_the_pressure_within_an_increment)
{
  Element<ModifiedCamClay> fine = triaxial(8), coarse = fine;
  for (int k = 0; k < 4000; ++k) fine.compress(0.012 / 4000, 0.004 / 4000);
  coarse.compress(0.012, 0.004);
  // Simpson's rule: 2e-5 in a piece; pieces of the increment are smaller still.
  EXPECT_NEAR(coarse.q() / fine.q(), 1, 2e-5);
}

TEST(ModifiedCamClay, isotropic_virgin_compression_has_no_deviator)
{
  Element<ModifiedCamClay> soil = triaxial(1);
  for (int k = 0; k < 10; ++k) soil.compress(0.005, 0.005);
  EXPECT_NEAR(soil.pressure(), p0 * std::exp(0.15 / 0.1), 1e-8 * p0);
  EXPECT_NEAR(soil.state[0], soil.pressure(), 1e-8 * p0);
  EXPECT_NEAR(soil.q(), 0, 1e-6);
}

TEST(ModifiedCamClay, increments_converge_to_first_order_where_the_path_bends)
{
  const auto stress_after = [](int steps) {
    Element<ModifiedCamClay> soil = triaxial(1.5);
    shear_undrained(soil, 0.02, steps);
    return soil.q();
  };
  const Real exact = stress_after(20000), error_50 = std::abs(stress_after(50) - exact), error_100 = std::abs(stress_after(100) - exact);
  EXPECT_LT(error_100, 0.01 * exact);
  EXPECT_NEAR(error_50 / error_100, 2, 0.4);
}

TEST(ModifiedCamClay, soil_at_rest_begins_on_the_virgin_state_of_its_past)
{
  ModifiedCamClay law = sample_cam_clay();
  const Real k0 = virgin_k0(law);
  const SymTensor<3> virgin{{-k0 * p0, -p0, -k0 * p0}};
  Element<ModifiedCamClay> normal(law, virgin);
  EXPECT_NEAR(normal.q() * normal.q() + normal.pressure() * (normal.pressure() - normal.state[0]), 0, 1e-9 * p0 * p0)
      << "on the surface, M = 1";
  for (int k = 0; k < 20; ++k) normal.compress(1e-3, 0);
  EXPECT_NEAR(normal.stress[1], -p0 * std::exp(0.02 / 0.1), 1e-4 * p0) << "goes on along the virgin line at once";
  EXPECT_NEAR(normal.stress[0] / normal.stress[1], k0, 1e-6);

  law.overconsolidation_ratio = 3;
  Real past = 0, three_times = 0;
  initial_state(law, virgin, &past);
  law.overconsolidation_ratio = 1;
  initial_state(law, {{-k0 * 3 * p0, -3 * p0, -k0 * 3 * p0}}, &three_times);
  EXPECT_NEAR(past, three_times, 1e-9 * past);

  Real through_stress = 0;
  initial_state(law, {{-3 * p0, -p0, -3 * p0}}, &through_stress);
  const Real pressure = 7 * p0 / 3, q = 2 * p0;
  EXPECT_NEAR(through_stress, pressure + q * q / pressure, 1e-9 * p0) << "a stress beyond the virgin state is on the surface, not outside";

  Real at_surface = 0;
  initial_state(law, {}, &at_surface);
  EXPECT_EQ(at_surface, 2 * law.min_pressure);
}

TEST(ModifiedCamClay, soil_that_parts_carries_the_minimum_pressure)
{
  Element<ModifiedCamClay> soil = triaxial(1);
  for (int k = 0; k < 20; ++k) soil.compress(-0.05, -0.02);
  EXPECT_NEAR(soil.pressure(), soil.law.min_pressure, 1e-9 * soil.law.min_pressure);
  EXPECT_LE(soil.q(), std::sqrt(soil.pressure() * (soil.state[0] - soil.pressure())) * (1 + 1e-9)) << "on the surface at most, M = 1";
  soil.compress(0.05, 0.05);
  EXPECT_GT(soil.pressure(), soil.law.min_pressure);
  EXPECT_TRUE(std::isfinite(soil.pressure()));

  Element<ModifiedCamClay> at_surface(sample_cam_clay(), {});
  at_surface.compress(0, 0);
  EXPECT_EQ(at_surface.stress[0], -at_surface.law.min_pressure) << "soil without stress at the start gets the minimum";
}

TEST(ModifiedCamClay, stress_ends_on_or_inside_the_surface_for_any_increment)
{
  std::mt19937_64 random(23);
  std::uniform_real_distribution<Real> ratio(1, 20);
  int at_yield = 0;
  for (int n = 0; n < 4000; ++n) {
    ModifiedCamClay law = sample_cam_clay(0.6 + 0.05 * (n % 20));
    law.overconsolidation_ratio = n % 2 == 0 ? 1 : ratio(random);
    law.max_pressure = n % 3 == 0 ? 1e5 : 1e7;
    Element<ModifiedCamClay> soil(law, random_stress<3>(random, 1.5));
    for (int k = 0; k < 10; ++k) {
      update(soil.prepared, soil.stress, Increment<3, Real>{random_strain<3>(random, 2)}, soil.state);
      const Real size = soil.state[0], f = yield_value(soil.prepared, soil.pressure(), soil.q() * soil.q(), size);
      ASSERT_TRUE(std::isfinite(f) && std::isfinite(size)) << n << " " << k;
      ASSERT_LE(f, 1e-9 * size * size) << n << " " << k;
      ASSERT_GE(soil.pressure(), law.min_pressure * (1 - 1e-9));
      at_yield += f > -1e-9 * size * size;
    }
  }
  EXPECT_GT(at_yield, 4000) << "and most of them yield";
}

TEST(ModifiedCamClay, lanes_and_single_numbers_give_the_same_stress)
{
  expect_lanes_like_single_numbers(sample_cam_clay(), 1.4);
}

TEST(ModifiedCamClay, tangent_is_that_of_finite_differences)
{
  expect_tangent_of_differences(sample_cam_clay(), 1.2, 1e-2);
}

TEST(ModifiedCamClay, is_never_stiffer_than_the_time_step_is_made_for)
{
  ModifiedCamClay law = sample_cam_clay();
  law.max_pressure = 1e4;
  expect_no_stiffness_beyond_that_of_the_time_step(law, 1, 1e-9);
}

TEST(ModifiedCamClay, beyond_the_maximum_pressure_it_is_as_stiff_as_there)
{
  Element<ModifiedCamClay> soil = triaxial(1e3);
  soil.prepared.moduli.max_pressure = p0;
  soil.compress(0.001, 0.001);
  EXPECT_NEAR(soil.pressure(), p0 * (1 + 0.003 / 0.02), 1e-6 * p0);
}

TEST(ModifiedCamClay, answers_the_queries)
{
  const ModifiedCamClay law = sample_cam_clay();
  const Material soil = law;
  EXPECT_EQ(law_name(soil), "modified Cam clay");
  EXPECT_EQ(state_size(soil), 1);
  ASSERT_EQ(state_fields(soil).size(), 1u);
  EXPECT_EQ(state_fields(soil)[0].unit, "Pa");
  EXPECT_TRUE(yields(soil));
  EXPECT_FALSE(dilates(soil));
  EXPECT_FALSE(non_associated(soil));
  EXPECT_FALSE(varies(soil));
  EXPECT_FALSE(strength_at_rest(soil));
  const Elasticity elastic = elasticity(soil);
  EXPECT_NEAR(elastic.bulk, law.max_pressure * 2 / 0.04, 1);
  EXPECT_NEAR(elastic.shear / elastic.bulk, 3 * 0.4 / (2 * 1.3), 1e-12);
  EXPECT_NEAR(young_poisson(soil).young_modulus, 3 * elastic.bulk * (1 - 2 * 0.3), 1e-3);
  Real state = 0;
  initial_state(soil, isotropic(p0), &state);
  EXPECT_EQ(state, p0);
}

}  // namespace
}  // namespace berm::material::this_file
