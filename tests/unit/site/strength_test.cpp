// SPDX-License-Identifier: BSD-3-Clause
// Strength from a cone penetration test, against numbers by hand.
#include "site/strength.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace berm::site::this_file {
namespace {

constexpr Real degree = std::numbers::pi / 180;

Sounding made(const std::vector<Real>& depth, const std::vector<Real>& q_t)
{
  Sounding sounding;
  sounding.file = "made.csv";
  sounding.depth = depth;
  sounding.q_t = q_t;
  return sounding;
}

TEST(Strength, is_of_means_over_layers_that_grow_with_depth)
{
  const std::vector<Layer> layers = layers_of(made({0.02, 0.06, 0.1, 2.01, 2.19, 2.21}, {1, 3, 5, 7, 9, 11}));
  ASSERT_EQ(layers.size(), 4u);
  EXPECT_DOUBLE_EQ(layers[0].middle, 0.04);
  EXPECT_DOUBLE_EQ(layers[0].q_t, 2);
  EXPECT_DOUBLE_EQ(layers[1].top, 0.1);
  EXPECT_DOUBLE_EQ(layers[1].q_t, 5);
  // From 1 m on each layer ends at 1.1 times its top: 1, 1.1, ..., 1.949, 2.144, 2.358 m.
  EXPECT_NEAR(layers[2].top, 1.948717, 1e-6);
  EXPECT_DOUBLE_EQ(layers[2].q_t, 7);
  EXPECT_DOUBLE_EQ(layers[3].q_t, 10);
}

TEST(Strength, of_clay_is_the_net_cone_resistance_over_N_kt)
{
  const std::vector<Strength> s_u = undrained_strength(made({1, 2}, {155.81e3, 171.62e3}), 6000, 14).strength;
  ASSERT_EQ(s_u.size(), 2u);
  EXPECT_NEAR(s_u[0].value, 10e3, 1e-6);
  EXPECT_NEAR(s_u[1].value, 10e3, 1e-6);
}

TEST(Strength, of_a_layer_without_any_is_left_out_and_of_many_refused)
{
  const StrengthProfile one = undrained_strength(made({0, 1, 2, 3}, {-12e3, 155.81e3, 171.62e3, 187.43e3}), 6000, 14);
  ASSERT_EQ(one.without.size(), 1u);
  EXPECT_EQ(one.without[0].middle, 0);
  ASSERT_EQ(one.strength.size(), 3u);
  EXPECT_NEAR(one.strength[0].value, 10e3, 1e-6);
  EXPECT_THROW(undrained_strength(made({1, 2}, {155e3, 30e3}), 6000, 14), InputError);
  const StrengthProfile sand = friction_angle(made({0, 10, 10.01, 12, 14}, {0, 10e6, 10e6, 10e6, 10e6}), 10e3, Correlation::kulhawy_mayne);
  EXPECT_EQ(sand.without.size(), 1u);
}

TEST(Strength, of_sand_by_kulhawy_and_mayne)
{
  // q_t / p_a = 100, sigma'_v0 / p_a = 1: 17.6 + 22 = 39.6 deg.
  const std::vector<Strength> phi = friction_angle(made({10, 10.01}, {10e6, 10e6}), 10e3, Correlation::kulhawy_mayne).strength;
  ASSERT_EQ(phi.size(), 1u);
  EXPECT_NEAR(phi[0].value / degree, 39.6, 0.01);
}

TEST(Strength, of_sand_by_robertson_and_campanella)
{
  // q_t / sigma'_v0 = 100: tan phi = 2.29 / 2.68.
  const std::vector<Strength> phi = friction_angle(made({10, 10.01}, {10e6, 10e6}), 10e3, Correlation::robertson_campanella).strength;
  EXPECT_NEAR(std::tan(phi[0].value), 2.29 / 2.68, 1e-3);
}

TEST(Strength, of_sand_puts_layers_together_that_differ_by_two_degrees_at_most_and_ends_at_45_degrees)
{
  const std::vector<Strength> phi =
      friction_angle(made({10, 11, 12.1, 13.4}, {10e6, 11e6, 200e6, 200e6}), 10e3, Correlation::kulhawy_mayne).strength;
  ASSERT_EQ(phi.size(), 2u);
  EXPECT_NEAR(phi[1].value / degree, 45, 1e-9);
}

TEST(Strength, of_what_is_no_sand_is_refused)
{
  EXPECT_THROW(friction_angle(made({10, 11}, {0.3e6, 0.3e6}), 10e3, Correlation::kulhawy_mayne), InputError);
}

// By hand: s_u = 2.116 kPa + 3.6 kPa/m z is 3.70 kPa at 0.44 m; q_t = 14 s_u + 15.81 z of readings of which 0.38, 0.44 and 0.50 m make a layer.
TEST(Strength, that_is_put_into_a_sounding_comes_back_in_the_middle_of_its_layer)
{
  std::vector<Real> depth, q_t;
  for (int k = 0; k < 10; ++k) {
    depth.push_back(0.02 + 0.06 * k);
    q_t.push_back(14 * (2116 + 3600 * depth.back()) + 15810 * depth.back());
  }
  const std::vector<Strength> s_u = undrained_strength(made(depth, q_t), 6000, 14).strength;
  ASSERT_EQ(s_u.size(), 6u);
  EXPECT_NEAR(s_u[4].value, 3700, 1e-6);
}

}  // namespace
}  // namespace berm::site::this_file
