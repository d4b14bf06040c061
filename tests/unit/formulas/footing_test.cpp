// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/footing.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// Tabulated values have five digits: half a unit of the last.
constexpr Real digits = 0.0005;

TEST(Footing, n_q_and_n_c_are_those_of_the_tables)
{
  EXPECT_NEAR(n_q(30 * degree).value, 18.401, digits);
  EXPECT_NEAR(n_q(35 * degree).value, 33.296, digits);
  EXPECT_NEAR(n_c(30 * degree).value, 30.140, digits);
  EXPECT_NEAR(n_c(35 * degree).value, 46.124, digits);
  EXPECT_NEAR(n_c(0).value, 5.1416, digits / 10);
}

TEST(Footing, n_c_has_no_step_where_friction_vanishes)
{
  EXPECT_DOUBLE_EQ(n_q(0).value, 1);
  EXPECT_NEAR(n_c(1e-12).value, 2 + pi, 1e-10);  // its slope is of the order of 10
}

TEST(Footing, n_gamma_is_that_of_the_table_and_a_rough_base_carries_twice_as_much)
{
  EXPECT_NEAR(n_gamma(30 * degree, Base::rough).value, 14.754, 1e-9);
  EXPECT_NEAR(n_gamma(35 * degree, Base::rough).value, 34.476, 1e-9);
  EXPECT_NEAR(n_gamma(30 * degree, Base::smooth).value, 7.653, 1e-9);
  EXPECT_NEAR(n_gamma(35 * degree, Base::smooth).value, 17.577, 1e-9);
  for (const Real phi : {30., 32.5, 35.}) {
    const Real smooth = n_gamma(phi * degree, Base::smooth).value, rough = n_gamma(phi * degree, Base::rough).value;
    EXPECT_NEAR(rough / smooth, 1.945, 0.02) << phi;  // 1.928 and 1.961 at the ends
    EXPECT_GE(smooth, 7.653 - 1e-9);
    EXPECT_LE(rough, 34.476 + 1e-9);
  }
}

TEST(Footing, the_factor_of_design_codes_is_near_that_of_a_rough_base)
{
  for (const Real phi : {30., 35.}) {
    const Real exact = n_gamma(phi * degree, Base::rough).value;
    EXPECT_NEAR(n_gamma_hansen(phi * degree).value / exact, 1, 0.03) << phi;  // 2.1 % above and 1.6 % below
  }
}

TEST(Footing, a_horizontal_load_takes_half_of_the_vertical_one_before_the_base_slides)
{
  EXPECT_NEAR(n_c_inclined(0).value, n_c(0).value, 1e-12);
  EXPECT_NEAR(n_c_inclined(1).value, n_c(0).value / 2, 1e-12);
  // d/dh (acos h + sqrt(1 - h^2)) = -(1 + h) / sqrt(1 - h^2).
  for (const Real h : {0.2, 0.5, 0.8})
    EXPECT_NEAR((n_c_inclined(h + 1e-6).value - n_c_inclined(h - 1e-6).value) / 2e-6, -std::sqrt((1 + h) / (1 - h)), 1e-6) << h;
}

TEST(Footing, a_moment_leaves_the_effective_width_to_the_load)
{
  // Without H: v = b (2 + pi), the largest moment (2 + pi)/8 at half the load.
  for (const Real v : {0.5, 2.57, 5.}) EXPECT_NEAR(strip_moment_on_effective_width(v, 0).value, v * (1 - v / (2 + pi)) / 2, 1e-12) << v;
  EXPECT_NEAR(strip_moment_on_effective_width((2 + pi) / 2, 0).value, (2 + pi) / 8, 1e-12);
  // On the envelope of V and H no moment is left, and a base that slides leaves what slides: b = h.
  for (const Real h : {0.3, 0.7, 1.}) EXPECT_NEAR(strip_moment_on_effective_width(n_c_inclined(h).value, h).value, 0, 1e-9) << h;
  EXPECT_NEAR(strip_moment_on_effective_width(1, 0.6).value, 0.2, 1e-12);
  const Real b = 0.8, h = 0.4, v = b * n_c_inclined(h / b).value;
  EXPECT_NEAR(strip_moment_on_effective_width(v, h).value, v * (1 - b) / 2, 1e-12);
  EXPECT_FALSE(strip_moment_on_effective_width(5, 0.9).valid);
}

TEST(Footing, the_arc_through_both_edges_is_the_one_that_carries_least)
{
  const auto moment = [](Real a) { return a / (2 * std::sin(a) * std::sin(a)); };
  const Real least = strip_moment_of_arc().value;
  EXPECT_NEAR(least, 0.690, 0.0005);
  for (Real a = 0.2; a < 3; a += 0.01) EXPECT_GE(moment(a), least - 1e-12) << a;
  EXPECT_GT(least, (2 + pi) / 8) << "a base that sticks carries more than one on its effective width";
}

TEST(Footing, values_out_of_range_are_told)
{
  EXPECT_TRUE(n_q(0).valid);
  EXPECT_FALSE(n_q(-0.1).valid);
  EXPECT_FALSE(n_c(pi / 2).valid);
  EXPECT_TRUE(n_gamma(30 * degree, Base::rough).valid);
  EXPECT_TRUE(n_gamma(35 * degree, Base::rough).valid);
  EXPECT_FALSE(n_gamma(36 * degree, Base::rough).valid);
  EXPECT_FALSE(n_gamma(29 * degree, Base::smooth).valid);
  EXPECT_TRUE(n_gamma_hansen(15 * degree).valid);
  EXPECT_FALSE(n_gamma_hansen(51 * degree).valid);
}

TEST(Footing, a_source_says_how_far_to_trust_it)
{
  EXPECT_STREQ(word_of(n_q(0.5).source.label), "exact");
  EXPECT_STREQ(word_of(n_gamma_hansen(0.5).source.label), "fit");
  EXPECT_STREQ(word_of(Label::fit), "fit");
}

TEST(Footing, round_and_strip_on_clay_whose_strength_grows_go_through_their_tables)
{
  EXPECT_NEAR(n_c_circle(0, Base::smooth).value, 5.689, 1e-12);
  EXPECT_NEAR(n_c_circle(0, Base::rough).value, 6.048, 1e-12);
  EXPECT_NEAR(n_c_circle(4, Base::rough).value, 8.742, 1e-12);
  EXPECT_NEAR(n_c_circle(8, Base::smooth).value, 8.994, 1e-12);
  EXPECT_NEAR(n_c_strip(0, Base::rough).value, 2 + pi, 1e-12);
  EXPECT_NEAR(n_c_strip(2, Base::smooth).value, 6.661, 1e-12);
  EXPECT_FALSE(n_c_circle(9, Base::smooth).valid);
}

TEST(Footing, below_the_surface_has_Skemptons_factor_which_grows_to_two_and_a_half_widths)
{
  EXPECT_NEAR(n_c_skempton(0, true).value, 6, 1e-12);
  EXPECT_NEAR(n_c_skempton(1, false).value, 6, 1e-12);
  EXPECT_NEAR(n_c_skempton(2.5, true).value, 9, 1e-12);
  EXPECT_NEAR(n_c_skempton(4, false).value, 7.5, 1e-12);
  EXPECT_FALSE(n_c_skempton(-0.1, true).valid);
}

TEST(Footing, round_on_sand_goes_through_its_table)
{
  EXPECT_NEAR(n_gamma_circle(20 * degree, Base::rough).value, 2.416, 1e-9);
  EXPECT_NEAR(n_gamma_circle(30 * degree, Base::smooth).value, 7.11, 1e-9);
  EXPECT_NEAR(n_gamma_circle(35 * degree, Base::rough).value, 41.88, 1e-9);
  EXPECT_FALSE(n_gamma_circle(40 * degree, Base::rough).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
