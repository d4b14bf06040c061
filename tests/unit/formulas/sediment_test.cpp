// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/sediment.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// By hand, d = 0.2 mm: D* = 2e-4 (16.181/1.8496e-12)^(1/3) = 2e-4 x 20604 = 4.121; 0.3/5.945 + 0.055 (1 - 0.92088) = 0.05046 + 0.00435.
TEST(CriticalShields, is_that_of_a_calculation_by_hand)
{
  EXPECT_NEAR(critical_shields(0.2e-3).value, 0.05481, 2e-5);
  EXPECT_NEAR(critical_shields(2e-3).value, 0.3 / 50.45 + 0.055 * (1 - 0.43859), 2e-5) << "D* = 41.21";
  EXPECT_FALSE(critical_shields(0.01e-3).valid) << "silt";
}

// By hand, U = 0.6 m/s, T = 10 s, d = 0.2 mm: A = 0.9549 m, A/(2.5 d) = 1909.9, f_w = 0.237 x 1909.9^-0.52 = 0.237 x 0.019673 = 0.0046625, tau_w/rho = 8.3925e-4 m2/s2.
TEST(Shields, of_waves_and_a_current_is_that_of_a_calculation_by_hand)
{
  const Real unit = 1.65 * 9.80665 * 0.2e-3;
  EXPECT_NEAR(shields_parameter({.velocity = 0.6, .period = 10}, 0.2e-3).value, 8.3925e-4 / unit, 1e-4 * 8.3925e-4 / unit);
  // V_r = 0.5 m/s at 1 m over z_0 = 1e-5 m: (0.4 x 0.5/11.51294)^2 = 3.0178e-4; mean 3.0178e-4 (1 + 1.2 x 0.73552^3.2) = 4.3729e-4.
  BedFlow flow;
  flow.current = 0.5, flow.height = 1, flow.roughness = 1e-5;
  EXPECT_NEAR(shields_parameter(flow, 0.2e-3).value, 3.0178e-4 / unit, 1e-4 * 3.0178e-4 / unit);
  flow.velocity = 0.6, flow.period = 10;
  EXPECT_NEAR(shields_parameter(flow, 0.2e-3).value, (4.3729e-4 + 8.3925e-4) / unit, 3e-4 * 1.3e-3 / unit);
  flow.angle = pi / 2;
  EXPECT_NEAR(shields_parameter(flow, 0.2e-3).value, std::hypot(4.3729e-4, 8.3925e-4) / unit, 3e-4 * 1.3e-3 / unit);
}

}  // namespace
}  // namespace berm::formulas::this_file
