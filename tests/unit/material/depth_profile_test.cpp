// SPDX-License-Identifier: BSD-3-Clause
#include "material/depth_profile.hpp"

#include "material/material.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::material::this_file {
namespace {

MohrCoulomb soil(Real friction_degrees, std::optional<Real> cutoff = {})
{
  MohrCoulomb law;
  law.density = 1800;
  law.young_modulus = 2e6;
  law.poisson_ratio = 0.3;
  law.cohesion = 4e3;
  law.friction_angle = friction_degrees * pi / 180;
  law.dilation_angle = law.friction_angle / 3;
  law.tension_cutoff = cutoff;
  law.cohesion_gradient = 3e3;
  law.young_modulus_gradient = 5e5;
  return law;
}

Clay clay()
{
  Clay law;
  law.density = 1800;
  law.young_modulus = 2e6;
  law.poisson_ratio = 0.45;
  law.undrained_strength = 4e3;
  law.rate_parameter = 0.1;
  law.reference_rate = 1e-3;
  law.sensitivity = 3;
  law.ductility = 10;
  law.undrained_strength_gradient = 3e3;
  law.young_modulus_gradient = 5e5;
  return law;
}

TEST(DepthProfile, is_linear_between_its_entries_and_constant_beyond_them)
{
  DepthProfile profile;
  profile.depth = {1, 2, 4};
  const std::vector<Real> values = {10, 20, 0};
  const std::pair<Real, Real> expected[] = {{0, 10}, {1, 10}, {1.25, 12.5}, {2, 20}, {3, 10}, {4, 0}, {9, 0}};
  for (const auto& [depth, value] : expected) EXPECT_DOUBLE_EQ(value_at(profile, values, depth), value) << depth;
}

TEST(AtDepth, gives_strength_and_stiffness_of_gradients_and_profiles_and_no_longer_varies)
{
  const MohrCoulomb deep = at_depth(soil(0), 2);
  EXPECT_EQ(deep.cohesion, 1e4);
  EXPECT_EQ(deep.young_modulus, 3e6);
  EXPECT_FALSE(varies(deep));
  EXPECT_TRUE(varies(soil(0)));

  MohrCoulomb table = soil(0);
  table.cohesion_gradient = table.young_modulus_gradient = 0;
  EXPECT_FALSE(varies(table));
  table.profile.depth = {0, 2};
  table.profile.strength = {4e3, 8e3};
  EXPECT_TRUE(varies(table));
  EXPECT_EQ(at_depth(table, 1).cohesion, 6e3);
  EXPECT_EQ(at_depth(table, 1).young_modulus, 2e6);
  EXPECT_EQ(at_depth(table, -1).cohesion, 4e3);
  EXPECT_FALSE(varies(at_depth(table, 1)));
}

/// Largest difference of the stress after an increment of a law that is prepared at a depth and one whose particles keep the values of that depth, over the strength.
template <int dim, class L>
Real worst_difference(const L& law, Real depth)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> any_number(-1, 1);
  const L there = at_depth(law, depth);
  const auto exact = prepare(there);
  Real own[2] = {}, worst = 0;
  const std::vector<Real> values = local_values(there);
  std::copy(values.begin(), values.end(), own);
  const auto kept = with_local(prepare(law), own);
  for (int n = 0; n < 2000; ++n) {
    SymTensor<dim> a, b;
    Increment<dim, Real> increment{.strain = {}, .dt = 1e-3, .time = 0};
    for (int k = 0; k < tensor_size<dim>; ++k) {
      a[k] = b[k] = 2e4 * any_number(random) - (k < 3 ? 1e4 : 0);
      increment.strain[k] = 5e-3 * any_number(random);
    }
    Real state_a[3] = {}, state_b[3] = {};
    update(exact, a, increment, state_a);
    update(kept, b, increment, state_b);
    for (int k = 0; k < tensor_size<dim>; ++k) worst = std::max(worst, std::abs(a[k] - b[k]) / 1e4);
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(state_a[k] - state_b[k]) / std::max(Real(1), std::abs(state_a[k])));
  }
  return worst;
}

TEST(WithOwn, is_the_law_prepared_with_the_values_of_that_depth)
{
  constexpr Real rounding = 1e-11;  // moduli and strength differ in the last digits
  LinearElastic solid;
  solid.density = 1800;
  solid.young_modulus = 2e6;
  solid.poisson_ratio = 0.3;
  solid.young_modulus_gradient = 5e5;
  for (const Real depth : {0., 0.7, 30.}) {
    EXPECT_LT(worst_difference<2>(soil(0), depth), rounding);
    EXPECT_LT(worst_difference<2>(soil(30), depth), rounding);
    EXPECT_LT(worst_difference<2>(soil(30, 5e3), depth), rounding);  // above the apex at the surface, below it 30 m down
    EXPECT_LT(worst_difference<2>(soil(0, 2e3), depth), rounding);
    EXPECT_LT(worst_difference<3>(soil(30, 5e3), depth), rounding);
    EXPECT_LT(worst_difference<2>(clay(), depth), rounding);
    EXPECT_LT(worst_difference<3>(clay(), depth), rounding);
    EXPECT_LT(worst_difference<2>(solid, depth), rounding);
  }
}

TEST(WithOwn, takes_values_lane_by_lane)
{
  const PreparedMohrCoulomb prepared = prepare(soil(30, 5e3));
  Lanes own[2];
  for (int l = 0; l < lanes; ++l) own[0][l] = 4e3 + 3e3 * l, own[1][l] = 2e6 + 1e6 * l;
  SymTensor<2, Lanes> stress{};
  Increment<2, Lanes> increment{.strain = {}, .dt = 1e-3, .time = 0};
  for (int k = 0; k < 4; ++k) increment.strain[k] = all_lanes(k == 1 ? -0.02 : 0.004);
  Lanes state[1] = {};
  update(with_local(prepared, own), stress, increment, state);
  for (int l = 0; l < lanes; ++l) {
    const Real one[2] = {own[0][l], own[1][l]};
    SymTensor<2> alone{};
    Increment<2, Real> same{.strain = {}, .dt = 1e-3, .time = 0};
    for (int k = 0; k < 4; ++k) same.strain[k] = increment.strain[k][l];
    Real state_alone[1] = {};
    update(with_local(prepared, one), alone, same, state_alone);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(stress[k][l], alone[k], 1e-12 * 1e5);
  }
}

}  // namespace
}  // namespace berm::material::this_file
