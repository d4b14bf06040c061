// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/axial.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

TEST(Axial, wedging_is_the_normal_force_over_V_for_a_stress_that_falls_with_the_cosine)
{
  for (const Real w : {0.02, 0.1, 0.25, 0.4, 0.5}) {
    const Real b = contact_angle(1, w);
    EXPECT_NEAR(1 - std::cos(b), 2 * w, 1e-12);
    constexpr int steps = 20000;
    Real normal = 0, vertical = 0;
    for (int k = 0; k < steps; ++k) {
      const Real angle = -b + 2 * b * (k + 0.5) / steps;
      normal += std::cos(angle);
      vertical += std::cos(angle) * std::cos(angle);
    }
    EXPECT_NEAR(wedging_factor(1, w).value, normal / vertical, 1e-8) << w;
  }
}

TEST(Axial, wedging_is_that_of_the_tables)
{
  EXPECT_NEAR(wedging_factor(0.8, 0.08).value, 1.068, 5e-4);
  EXPECT_NEAR(wedging_factor(0.8, 0.2).value, 1.170, 5e-4);
  EXPECT_NEAR(wedging_factor(0.8, 0.4).value, 4 / pi, 1e-12);
  EXPECT_NEAR(wedging_factor(0.8, 0.7).value, 4 / pi, 1e-12) << "soil beside the pipe presses no more than at half of its height";
}

TEST(Axial, at_the_surface_nothing_wedges_and_nothing_sticks)
{
  EXPECT_EQ(wedging_factor(1, 0).value, 1);
  EXPECT_FALSE(wedging_factor(1, -0.1).valid);
  EXPECT_EQ(axial_undrained(1, 0, 1000).value, 0);
}

TEST(Axial, resistance_is_friction_of_the_normal_force_or_strength_over_the_contact)
{
  EXPECT_NEAR(axial_drained(1, 0.5, 30 * degree, 1000).value, 4 / pi * std::tan(30 * degree) * 1000, 1e-9);
  EXPECT_NEAR(axial_undrained(1, 0.5, 1000).value, 1000 * pi / 2, 1e-9) << "half of the circumference";
}

// stucharo/PSI, tests/test_PSI_Clay_Calc.py
TEST(Axial, wedging_is_that_of_a_public_program)
{
  EXPECT_NEAR(contact_angle(1, 0.1), 0.64350111, 1e-8);
  EXPECT_NEAR(wedging_factor(1, 0.1).value, 1.06808973, 1e-8);
  EXPECT_NEAR(wedging_factor(1, 0.6).value, 1.27323954, 1e-8);
}

TEST(Axial, displacements_are_those_of_the_table)
{
  const Estimates small = f114_axial_breakout_displacement(0.1), large = f114_axial_breakout_displacement(0.6);
  EXPECT_NEAR(small.low.value, 0.25e-3, 1e-12);
  EXPECT_NEAR(small.best.value, 1e-3, 1e-12);
  EXPECT_NEAR(large.low.value, 1.25e-3, 1e-12);
  EXPECT_NEAR(large.best.value, 5e-3, 1e-12);
  EXPECT_NEAR(large.high.value, 50e-3, 1e-12);
  EXPECT_EQ(citation(large.best.source), "DNVGL-RP-F114, table 4-2");
}

// By hand: 3 kPa over pi (4 + 3.8) m times 1 m.
TEST(Axial, friction_of_a_skirt_acts_on_both_of_its_faces)
{
  EXPECT_NEAR(skirt_friction(4, 3.8, 1, 3e3).value, 73513.27, 0.01);
  EXPECT_TRUE(skirt_friction(4, 3.8, 1, 3e3).valid);
  EXPECT_FALSE(skirt_friction(4, 0, 1, 3e3).valid);
}

TEST(Axial, residual_displacements_are_those_of_a_public_program)
{
  // Sivamanikantakumar122, surfacelaid_psi_backend.py: min(7.5, 0.015 D), min(30, 0.06 D), max(250, 0.5 D) mm.
  const Estimates small = f114_axial_residual_displacement(0.1), large = f114_axial_residual_displacement(0.6);
  EXPECT_NEAR(small.low.value, 1.5e-3, 1e-12);
  EXPECT_NEAR(small.best.value, 6e-3, 1e-12);
  EXPECT_NEAR(small.high.value, 0.25, 1e-12);
  EXPECT_NEAR(large.low.value, 7.5e-3, 1e-12);
  EXPECT_NEAR(large.best.value, 30e-3, 1e-12);
  EXPECT_NEAR(large.high.value, 0.3, 1e-12);
}

// By hand: D = 0.4 m, w = 0.1 m: b = acos(0.5) = 60 deg, zeta = 2 sin 60/(pi/3 + sin 60 cos 60) = 1.7320508/1.4802103 = 1.1701383; OCR = 1.5, m = 0.8:
// 1.3831618; 0.5 x 0.25 x 1.3831618 x 1.1701383 x 1200 N/m = 242.77 N/m.
TEST(Axial, of_consolidated_clay_grows_with_the_load_it_carried_and_the_part_that_it_consolidated_under)
{
  const ConsolidatedInterface clay{0.25, 0.8, 0.5, 1.5};
  EXPECT_NEAR(axial_consolidated(0.4, 0.1, 1200, 1, clay).value, 242.77, 0.01);
  EXPECT_NEAR(axial_consolidated(0.4, 0.1, 1200, 0.5, clay).value, 242.77 / 2, 0.01);
  EXPECT_NEAR(axial_consolidated(0.4, 0.1, 1200, 1, {0.25, 0.8, 0.5, 0.7}).value, 0.125 * 1.1701383 * 1200, 0.01)
      << "never overconsolidated";
  EXPECT_FALSE(axial_consolidated(0.4, 0.1, 1200, 1.1, clay).valid);
}

// By hand: D = 0.4 m, w = 0.2386 D, s_u = 2 kPa + 1.5 kPa/m z, alpha = 0.5: b = acos(1 - 2 x 0.2386) = 1.020664, the arc D b = 0.408266 m, s_u = 2.14316 kPa at the invert.
TEST(Axial, resistance_and_wedging_of_a_flowline_are_those_of_a_hand_check)
{
  constexpr Real D = 0.4, w = 0.2386 * D, alpha = 0.5;
  EXPECT_NEAR(D * contact_angle(D, w), 0.408266, 1e-6);
  EXPECT_NEAR(axial_undrained(D, w, alpha * 2143.16).value, 437.489, 1e-3);
  EXPECT_NEAR(wedging_factor(D, w).value, 1.162708, 1e-6);
}

}  // namespace
}  // namespace berm::formulas::this_file
