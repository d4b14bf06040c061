// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_clay.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

PipeInClay pipe_at(Real relative_embedment, Real roughness = 0)
{
  return {.diameter = 0.3, .embedment = 0.3 * relative_embedment, .strength = 2000, .roughness = roughness};
}

constexpr Real D_su = 0.3 * 2000;

TEST(PipeInClay, slip_lines_give_the_tabulated_loads)
{
  const Real table[][2] = {{0.05, 2.048}, {0.1, 2.713}, {0.2, 3.430}, {0.3, 3.787}, {0.5, 4.000}};
  for (const auto& [x, V] : table) {
    EXPECT_NEAR(clay_vertical_smooth(pipe_at(x)).value / D_su, V, 0.0005) << x;  // four digits
    EXPECT_TRUE(clay_vertical_smooth(pipe_at(x)).valid);
  }
}

TEST(PipeInClay, slip_lines_are_a_lower_bound_where_the_pipe_touches_the_clay_over_more_than_45_degrees)
{
  EXPECT_NEAR(clay_slip_lines_exact_to, (1 - std::sqrt(0.5)) / 2, 1e-12);
  EXPECT_EQ(clay_vertical_smooth(pipe_at(0.14)).source.label, Label::exact);
  for (const Real x : {0.15, 0.3, 0.5}) EXPECT_EQ(clay_vertical_smooth(pipe_at(x)).source.label, Label::lower_bound) << x;
  EXPECT_STREQ(word_of(Label::lower_bound), "lower bound");
}

TEST(PipeInClay, a_barely_embedded_smooth_pipe_is_a_footing_of_its_contact_width)
{
  const Real x = 1e-6, width = 2 * std::sqrt(x - x * x);
  EXPECT_NEAR(clay_vertical_smooth(pipe_at(x)).value / D_su / width, 2 + pi, 0.005);  // the next term is theta = 0.002
}

TEST(PipeInClay, fits_have_their_coefficients_at_half_a_diameter)
{
  EXPECT_NEAR(clay_vertical(pipe_at(0.5)).value / D_su, 4.534, 0.0005);     // 5.66 / 2^0.32
  EXPECT_NEAR(clay_vertical(pipe_at(0.5, 1)).value / D_su, 5.608, 0.0005);  // 7.40 / 2^0.40
  EXPECT_NEAR(clay_horizontal(pipe_at(0.5)).value / D_su, 1.584, 0.0005);
  EXPECT_NEAR(clay_horizontal(pipe_at(0.5, 1)).value / D_su, 1.847, 0.0005);
  EXPECT_NEAR(clay_vertical_with_heave(pipe_at(0.5)).value / D_su, 4.457, 0.0005);
  EXPECT_NEAR(clay_vertical_with_heave(pipe_at(0.5, 1)).value / D_su, 5.648, 0.0005);
}

TEST(PipeInClay, the_smooth_fit_is_no_more_than_14_percent_off_the_slip_lines)
{
  for (const Real x : {0.05, 0.1, 0.2, 0.3, 0.5}) {
    EXPECT_NEAR(clay_vertical(pipe_at(x)).value / clay_vertical_smooth(pipe_at(x)).value, 1, 0.14) << x;  // 13.4 % at 0.5 D
  }
}

TEST(PipeInClay, roughness_goes_from_the_smooth_to_the_rough_fit_in_a_straight_line)
{
  for (const auto fit : {clay_vertical, clay_horizontal, clay_vertical_with_heave}) {
    const Real smooth = fit(pipe_at(0.2)).value, rough = fit(pipe_at(0.2, 1)).value;
    EXPECT_GT(rough, smooth);
    EXPECT_NEAR(fit(pipe_at(0.2, 0.25)).value, 0.75 * smooth + 0.25 * rough, 1e-12 * rough);
  }
}

TEST(PipeInClay, the_envelope_has_its_apex_where_its_exponents_say)
{
  for (const Real roughness : {0., 0.5, 1.}) {
    for (const Real x : {0.1, 0.5}) {
      const PipeInClay pipe = pipe_at(x, roughness);
      const Real b1 = (0.8 - 0.15 * roughness) * (1.2 - x), b2 = 0.35 * (2.5 - x), v = b1 / (b1 + b2);
      const auto H = [&](Real V) { return clay_envelope(pipe, V, 3000, 700).value; };
      EXPECT_NEAR(H(3000 * v), 700, 1e-9);
      const Real step = 3;  // dH/dV is 0 but for the curve's third derivative, of the order of H_max/V_max^3
      EXPECT_NEAR((H(3000 * v + step) - H(3000 * v - step)) / (2 * step), 0, 1e-6);
    }
  }
}

TEST(PipeInClay, the_envelope_can_be_drawn_from_no_load_to_the_largest)
{
  const PipeInClay pipe = pipe_at(0.3, 0.5);
  const auto H = [&](Real V) { return clay_envelope(pipe, V, 3000, 700); };
  EXPECT_EQ(H(0).value, 0);
  EXPECT_EQ(H(3000).value, 0);
  for (int k = 1; k < 100; ++k) {
    EXPECT_TRUE(H(30. * k).valid);
    EXPECT_GT(H(30. * k).value, 0);
    EXPECT_LE(H(30. * k).value, 700 + 1e-9);
  }
  EXPECT_FALSE(H(-1).valid);
  EXPECT_FALSE(H(3001).valid);
  EXPECT_TRUE(std::isnan(H(3001).value));
}

TEST(PipeInClay, soil_flows_around_a_deep_pipe_at_the_tabulated_load)
{
  EXPECT_NEAR(clay_deep(pipe_at(5)).value / D_su, 9.14, 0.005);
  EXPECT_NEAR(clay_deep(pipe_at(5, 1)).value / D_su, 11.94, 0.005);
  EXPECT_NEAR(clay_deep(pipe_at(5)).value / D_su, 6 + pi, 1e-12);
  EXPECT_NEAR(clay_deep(pipe_at(5, 1)).value / D_su, 4 * std::sqrt(2.) + 2 * pi, 1e-12);
  EXPECT_EQ(clay_deep(pipe_at(5, 1)).source.label, Label::exact);
  EXPECT_EQ(clay_deep(pipe_at(5, 0.5)).source.label, Label::recalled);
  EXPECT_TRUE(clay_deep(pipe_at(5)).valid);
  EXPECT_FALSE(clay_deep(pipe_at(0.5)).valid);
}

TEST(PipeInClay, slip_lines_and_the_rough_fit_agree_with_the_bounds_at_half_a_diameter)
{
  const Real smooth = clay_vertical_smooth(pipe_at(0.5)).value / D_su;
  EXPECT_GE(smooth, murff_smooth.lower - 1e-12);
  EXPECT_LE(smooth, murff_smooth.upper);
  EXPECT_NEAR(clay_vertical(pipe_at(0.5, 1)).value / D_su, murff_rough.lower, 0.05);  // bounds are given to two digits
  EXPECT_EQ(murff_source.label, Label::recalled);
}

TEST(PipeInClay, values_out_of_range_are_told)
{
  for (const auto fit : {clay_vertical_smooth, clay_vertical, clay_horizontal, clay_vertical_with_heave}) {
    EXPECT_TRUE(fit(pipe_at(0.5)).valid);
    EXPECT_FALSE(fit(pipe_at(0.51)).valid);
    EXPECT_FALSE(fit(pipe_at(0.3, 1.1)).valid);
    EXPECT_TRUE(std::isnan(fit(pipe_at(-0.1)).value));
    PipeInClay growing = pipe_at(0.3);
    growing.strength_gradient = 1000;
    EXPECT_FALSE(fit(growing).valid);
  }
  EXPECT_FALSE(clay_vertical_smooth(pipe_at(0.3, 0.5)).valid);
  EXPECT_TRUE(clay_vertical(pipe_at(0.3, 0.5)).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
