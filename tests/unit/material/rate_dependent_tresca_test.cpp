// SPDX-License-Identifier: BSD-3-Clause
#include "material/rate_dependent_tresca.hpp"

#include "material/material.hpp"
#include "material/tangent.hpp"
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material {
namespace {

constexpr Real reference_rate = 1e-5, rate_parameter = 0.1, strength = 4e3;

RateDependentTresca clay(Real part = rate_parameter)
{
  RateDependentTresca law;
  law.density = 1700;
  law.young_modulus = 2e6;
  law.poisson_ratio = 0.49;
  law.undrained_strength = strength;
  law.rate_parameter = part;
  law.reference_rate = reference_rate;
  return law;
}

/// The same clay whose strength is the same at all rates.
MohrCoulomb tresca()
{
  MohrCoulomb law;
  law.density = 1700;
  law.young_modulus = 2e6;
  law.poisson_ratio = 0.49;
  law.cohesion = strength;
  return law;
}

/// (s1 - s3)/2 of clay that is shortened along y and stretched along x, without change of volume, at a rate of the engineering shear strain until it
/// flows; `state` ends as what the particle keeps.
template <int dim>
Real strength_at_rate(Real rate, Real& state)
{
  const PreparedRateDependentTresca law = prepare(clay());
  SymTensor<dim> stress;
  constexpr Real shear = 1e-3;
  for (int step = 0; step < 20; ++step) {
    Increment<dim, Real> increment;
    increment.strain[0] = shear / 2;
    increment.strain[1] = -shear / 2;
    increment.dt = shear / rate;
    update(law, stress, increment, &state);
  }
  return (stress[0] - stress[1]) / 2;
}

TEST(RateDependentTresca, strength_grows_by_the_same_part_for_each_tenfold_rate)
{
  for (const auto& [decades, expected] : {std::pair{0., 4000.}, {1., 4400.}, {2., 4800.}, {0.5, 4200.}}) {
    Real plane = 0, space = 0;
    EXPECT_NEAR(strength_at_rate<2>(reference_rate * std::pow(10, decades), plane), expected, 1e-8) << decades;
    EXPECT_NEAR(strength_at_rate<3>(reference_rate * std::pow(10, decades), space), expected, 1e-8) << decades;
    EXPECT_NEAR(plane, expected - strength, 1e-8) << "is kept as what the rate adds";
    EXPECT_NEAR(space, expected - strength, 1e-8);
  }
}

TEST(RateDependentTresca, strength_below_the_reference_rate_is_that_of_the_reference_rate)
{
  for (const Real part : {0.5, 1e-3, 1e-9}) {
    Real added = 7;
    EXPECT_NEAR(strength_at_rate<2>(part * reference_rate, added), strength, 1e-9);
    EXPECT_EQ(added, 0);
  }
}

TEST(RateDependentTresca, an_increment_without_time_has_no_rate)
{
  const PreparedRateDependentTresca law = prepare(clay());
  SymTensor<2> stress;
  Real added = 7;
  update(law, stress, {{{0.01, -0.01, 0, 0}}}, &added);
  EXPECT_NEAR((stress[0] - stress[1]) / 2, strength, 1e-9);
  EXPECT_EQ(added, 0);
}

TEST(RateDependentTresca, returned_stress_is_on_or_inside_the_surface_of_its_rate)
{
  std::mt19937_64 random(11);
  const PreparedRateDependentTresca law = prepare(clay());
  for (int n = 0; n < 10000; ++n) {
    const Increment<3, Real> increment{elastic_strain(law.elastic, random_trial<3>(random)), std::exp2(random() % 30)};
    SymTensor<3> stress = random_trial<3>(random), trial = stress;
    add_elastic_stress(law.elastic, trial, increment.strain);
    Real added = 0;
    update(law, stress, increment, &added);
    PreparedMohrCoulomb surface = law.tresca;
    surface.strength += added;
    const Real rounding = 1e-13 * (size_of(trial) + strength), outside = yield_value(surface, stress);
    ASSERT_LE(outside, rounding);
    if (yield_value(surface, trial) > rounding) {
      ASSERT_NEAR(outside, 0, rounding) << "a stress outside comes to rest on the surface";
    }
    ASSERT_NEAR(trace(stress), trace(trial), rounding) << "flow keeps the volume";
  }
}

TEST(RateDependentTresca, without_a_rate_effect_it_is_mohr_coulomb_without_friction)
{
  std::mt19937_64 random(12);
  const PreparedRateDependentTresca law = prepare(clay(0));
  const PreparedMohrCoulomb same = prepare(tresca());
  for (int n = 0; n < 10000; ++n) {
    const Increment<2, Real> increment{elastic_strain(law.elastic, random_trial<2>(random)), 1e-3};
    SymTensor<2> stress = random_trial<2>(random), other = stress;
    Real added = 0, opening = 0;
    update(law, stress, increment, &added);
    update(same, other, increment, &opening);
    for (int k = 0; k < 4; ++k) ASSERT_EQ(stress[k], other[k]);
    ASSERT_EQ(added, 0);
  }
}

TEST(RateDependentTresca, lanes_and_single_numbers_give_the_same_stress)
{
  std::mt19937_64 random(13);
  const PreparedRateDependentTresca law = prepare(clay());
  for (int block = 0; block < 1000; ++block) {
    SymTensor<2, Lanes> stresses;
    Increment<2, Lanes> increments{{}, 1e2};
    SymTensor<2> stress[lanes];
    Increment<2, Real> increment[lanes];
    Real added[lanes] = {}, size[lanes];
    for (int l = 0; l < lanes; ++l) {
      stress[l] = random_trial<2>(random);
      increment[l] = {elastic_strain(law.elastic, random_trial<2>(random)), 1e2};
      SymTensor<2> trial = stress[l];
      add_elastic_stress(law.elastic, trial, increment[l].strain);
      size[l] = size_of(trial) + size_of(stress[l]) + strength;
      for (int k = 0; k < 4; ++k) {
        stresses[k][l] = stress[l][k];
        increments.strain[k][l] = increment[l].strain[k];
      }
    }
    Lanes addeds{};
    update(law, stresses, increments, &addeds);
    for (int l = 0; l < lanes; ++l) {
      update(law, stress[l], increment[l], &added[l]);
      // The compiler may fuse products and sums in one form and not in the other.
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(stresses[k][l], stress[l][k], 1e-13 * size[l]);
      ASSERT_NEAR(addeds[l], added[l], 1e-12 * strength);
    }
  }
}

TEST(RateDependentTresca, all_lanes_of_one_increment_give_the_same_bits)
{
  std::mt19937_64 random(14);
  const PreparedRateDependentTresca law = prepare(clay());
  for (int block = 0; block < 1000; ++block) {
    const SymTensor<2> before = random_trial<2>(random), strain = elastic_strain(law.elastic, random_trial<2>(random));
    SymTensor<2, Lanes> stress;
    Increment<2, Lanes> increment{{}, 1e2};
    for (int k = 0; k < 4; ++k) {
      stress[k] = all_lanes(before[k]);
      increment.strain[k] = all_lanes(strain[k]);
    }
    Lanes added{};
    update(law, stress, increment, &added);
    for (int l = 1; l < lanes; ++l) {
      for (int k = 0; k < 4; ++k) ASSERT_EQ(stress[k][l], stress[k][0]);
      ASSERT_EQ(added[l], added[0]);
    }
  }
}

TEST(RateDependentTresca, tangent_is_that_of_finite_differences)
{
  const PreparedRateDependentTresca law = prepare(clay());
  const SymTensor<2> before{{-1e3, -2e3, -1.5e3, 5e2}};
  const Increment<2, Real> increment{{{4e-3, -3e-3, 0, 2e-3}}, 20};
  SymTensor<2> stress = before;
  Tangent tangent;
  Real added = 0;
  update_stress_and_tangent(law, stress, increment, &added, tangent);
  EXPECT_GT(added, 0.1 * strength);
  constexpr Real h = 1e-8;
  for (int j = 0; j < 3; ++j) {
    SymTensor<2> plus = before, minus = before;
    Increment<2, Real> more = increment, less = increment;
    const int place = j < 2 ? j : 3;
    more.strain[place] += j < 2 ? h : h / 2;
    less.strain[place] -= j < 2 ? h : h / 2;
    update(law, plus, more, &added);
    update(law, minus, less, &added);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(tangent(k, j), (plus[k] - minus[k]) / (2 * h), 1e-6 * p_wave_modulus(law.elastic));
  }
}

TEST(RateDependentTresca, strength_grows_with_depth_and_so_does_what_the_rate_adds)
{
  RateDependentTresca law = clay();
  law.undrained_strength_gradient = 2e3;
  const RateDependentTresca deep = at_depth(law, 3);
  EXPECT_EQ(deep.undrained_strength, 1e4);
  EXPECT_EQ(prepare(deep).per_decade, 1e3);
  EXPECT_EQ(at_depth(law, -1).undrained_strength, strength);
  EXPECT_TRUE(varies(law));
  EXPECT_FALSE(varies(deep));
}

TEST(RateDependentTresca, answers_what_a_soil_without_friction_answers)
{
  const Material soil = clay();
  EXPECT_TRUE(yields(soil));
  EXPECT_FALSE(dilates(soil));
  EXPECT_FALSE(non_associated(soil));
  ASSERT_TRUE(strength_at_rest(soil));
  EXPECT_EQ(strength_at_rest(soil)->cohesion, strength);
  EXPECT_EQ(strength_at_rest(soil)->friction_angle, 0);
  const Real added = 300;
  EXPECT_EQ(shear_strength(soil, -1e4, &added), strength + 300);
  ASSERT_EQ(state_fields(soil).size(), 1u);
  EXPECT_EQ(state_fields(soil)[0].unit, "Pa");
  EXPECT_EQ(state_size(soil), 1);
}

}  // namespace
}  // namespace berm::material
