// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/cone.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// Numbers below are by hand, with four digits kept in each step: 1e-3 of what follows from them.
TEST(Cone, clay_with_exponent_1)
{
  // q_t = 500 kPa, f_s = 12 kPa, sigma_v0 = 100 kPa, sigma'_v0 = 50 kPa: net 400, F_r = 3 %, n = 1: Q = 4 x 2 = 8.
  // I_c^2 = (3.47 - 0.9031)^2 + (0.4771 + 1.22)^2 = 6.589 + 2.880 = 9.469, I_c = 3.077; 0.381 x 3.077 + 0.025 - 0.15 = 1.047: n = 1.
  const SoilBehaviour soil = soil_behaviour(500e3, 12e3, 100e3, 50e3);
  EXPECT_DOUBLE_EQ(soil.n, 1);
  EXPECT_NEAR(soil.Q_tn, 8, 1e-9);
  EXPECT_NEAR(soil.F_r, 0.03, 1e-12);
  EXPECT_NEAR(soil.I_c.value, 3.077, 1e-3);
  EXPECT_EQ(zone_of(soil.I_c.value), 3);
}

TEST(Cone, sand_at_the_stress_of_the_atmosphere_needs_no_exponent)
{
  // q_t = 10.2 MPa, f_s = 50 kPa, sigma_v0 = 200 kPa, sigma'_v0 = 100 kPa: Q = 100 for every n, F_r = 0.5 %.
  // I_c^2 = (3.47 - 2)^2 + (-0.3010 + 1.22)^2 = 2.161 + 0.8446 = 3.005, I_c = 1.734; n = 0.6606 + 0.05 - 0.15 = 0.5605.
  const SoilBehaviour soil = soil_behaviour(10.2e6, 50e3, 200e3, 100e3);
  EXPECT_NEAR(soil.Q_tn, 100, 1e-9);
  EXPECT_NEAR(soil.I_c.value, 1.734, 1e-3);
  EXPECT_NEAR(soil.n, 0.5605, 1e-3);
  EXPECT_EQ(zone_of(soil.I_c.value), 6);
}

TEST(Cone, sand_at_a_quarter_of_it_by_substitution)
{
  // net = 5 MPa, f_s = 50 kPa (1 %), sigma'_v0 = 25 kPa, so Q = 50 x 4^n and I_c^2 = (1.771 - 0.6021 n)^2 + 1.22^2.
  // n = 0.5: 1.470, I_c = 1.910, n = 0.381 x 1.910 + 0.0125 - 0.15 = 0.5903; then 1.416, 1.869, 0.5746; 1.425, 1.876, 0.5773; 1.423, 1.875, 0.5768.
  const SoilBehaviour soil = soil_behaviour(5.05e6, 50e3, 50e3, 25e3);
  EXPECT_NEAR(soil.n, 0.5769, 1e-3);
  EXPECT_NEAR(soil.I_c.value, 1.875, 2e-3);
  EXPECT_NEAR(soil.Q_tn, 111.2, 0.3);  // 50 x 4^0.5768
}

TEST(Cone, has_no_index_without_friction_or_net_resistance)
{
  EXPECT_FALSE(soil_behaviour(500e3, 0, 100e3, 50e3).I_c.valid);
  EXPECT_FALSE(soil_behaviour(90e3, 5e3, 100e3, 50e3).I_c.valid);
  EXPECT_FALSE(soil_behaviour(500e3, nan, 100e3, 50e3).I_c.valid);
}

TEST(Cone, zones_end_where_the_chart_does)
{
  EXPECT_EQ(zone_of(1.30), 7);
  EXPECT_EQ(zone_of(1.31), 6);
  EXPECT_EQ(zone_of(2.04), 6);
  EXPECT_EQ(zone_of(2.06), 5);
  EXPECT_EQ(zone_of(2.61), 4);
  EXPECT_EQ(zone_of(2.96), 3);
  EXPECT_EQ(zone_of(3.61), 2);
}

TEST(Cone, unit_weight)
{
  // 1 MPa, 10 kPa: 0.36 + 0 + 1.236 = 1.596; 10 MPa, 50 kPa: 0.27 x -0.3010 + 0.72 + 1.236 = 1.8747; 100 kPa, 3 kPa: 0.1288 + 1.236 = 1.3648.
  EXPECT_NEAR(cone_unit_weight(1e6, 10e3, 1).value, 1.596, 1e-9);
  EXPECT_NEAR(cone_unit_weight(10e6, 50e3, 1).value, 1.8747, 1e-4);
  EXPECT_NEAR(cone_unit_weight(100e3, 3e3, 10e3).value, 13648, 1);
}

TEST(Cone, relative_density)
{
  // Q = 122: 0.268 x 4.80402 - 0.675 = 0.61248. At sigma'_v0 = 25 kPa half the resistance has the same. D_r is 1 at Q = e^6.25 = 518, 0 at e^2.51866 = 12.41.
  EXPECT_NEAR(cone_relative_density(12.2e6, 100e3).value, 0.61248, 1e-5);
  EXPECT_NEAR(cone_relative_density(6.1e6, 25e3).value, 0.61248, 1e-5);
  EXPECT_TRUE(cone_relative_density(51.7e6, 100e3).valid);
  EXPECT_FALSE(cone_relative_density(52e6, 100e3).valid);
  EXPECT_FALSE(cone_relative_density(1.24e6, 100e3).valid);
}

TEST(Cone, modulus)
{
  // I_c = 2: 10^(1.1 + 1.68) = 602.6, x 0.015 = 9.038 net resistances; I_c = 1.6: 10^2.56 = 363.1, 5.446. None from 2.60 on.
  EXPECT_NEAR(cone_modulus(2, 1e6).value / 1e6, 9.038, 1e-3);
  EXPECT_NEAR(cone_modulus(1.6, 5e6).value / 5e6, 5.446, 1e-3);
  EXPECT_FALSE(cone_modulus(2.6, 1e6).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
