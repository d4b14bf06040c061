// SPDX-License-Identifier: BSD-3-Clause
#include "sample_parameters.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace berm::macro_element::this_file {
namespace {

using State = berm_macro_element_state;

/// A pipe at w = 0.1 m under V, N/m.
State started(const Parameters& p, Real V)
{
  State state;
  EXPECT_EQ(berm_macro_element_start(&p, 0, 0.1, V, &state), BERM_MACRO_ELEMENT_OK);
  return state;
}

std::array<double, 2> step(const Parameters& p, State& state, double du, double dw, double K[2][2] = nullptr)
{
  const double by[2] = {du, dw};
  std::array<double, 2> F{};
  EXPECT_EQ(berm_macro_element_step(&p, &state, by, F.data(), K), BERM_MACRO_ELEMENT_OK);
  return F;
}

TEST(MacroElement, a_push_follows_the_resistance_of_fresh_soil)
{
  const Parameters p = sample_parameters();
  State state;
  ASSERT_EQ(berm_macro_element_start(&p, 0, 0, 0, &state), BERM_MACRO_ELEMENT_OK);
  for (const Real w : {0.02, 0.05, 0.1, 0.25}) {
    const Real V = step(p, state, 0, w - state.w)[1];
    EXPECT_NEAR(V, 1.2e4 * std::sqrt(state.w_p / 0.5), 1e-6) << "V0 at the plastic embedment";
    EXPECT_NEAR(state.w - state.w_p, V / 1e6, 1e-12) << "the rest is elastic";
  }
}

TEST(MacroElement, inside_the_surface_it_is_elastic_and_nothing_stays)
{
  Parameters p = sample_parameters();
  p.berm_rate = 0;
  const State before = started(p, 2000);
  State state = before;
  double K[2][2];
  const auto F = step(p, state, 1e-4, -2e-4, K);
  EXPECT_NEAR(F[0], 80, 1e-9);
  EXPECT_NEAR(F[1], 1800, 1e-9);
  EXPECT_DOUBLE_EQ(K[0][0], 8e5);
  EXPECT_DOUBLE_EQ(K[1][1], 1e6);
  EXPECT_DOUBLE_EQ(K[0][1], 0);
  EXPECT_DOUBLE_EQ(K[1][0], 0);
  step(p, state, -1e-4, 2e-4);
  EXPECT_NEAR(state.H, 0, 1e-9);
  EXPECT_NEAR(state.V, 2000, 1e-9);
  EXPECT_DOUBLE_EQ(state.u_p, before.u_p);
}

/// The surface at V, with what the path has mobilised and disturbed.
Real surface(const Parameters& p, const State& s, Real V)
{
  const Real V0 = p.backbone_factor * std::pow(s.w_p / p.diameter, p.backbone_power);
  const auto raw = [&](Real z) { return std::pow(z, p.surface_b1) * std::pow(1 - z, p.surface_b2); };
  const Real soft = p.residual_ratio + (1 - p.residual_ratio) * std::exp(-s.disturbed / p.softening_length);
  return p.peak_ratio * V0 * raw((V / V0 + p.surface_beta) / (1 + p.surface_beta)) / raw(p.surface_b1 / (p.surface_b1 + p.surface_b2)) *
         soft * (p.first_yield + (1 - p.first_yield) * s.mobilised);
}

TEST(MacroElement, a_drag_lies_on_the_yield_surface_and_falls_to_the_residual)
{
  Parameters p = sample_parameters();
  p.berm_rate = 0;
  State state = started(p, 2000);
  Real largest = 0;
  for (int k = 0; k < 400; ++k) {
    const auto F = step(p, state, 0.002, 0);
    EXPECT_NEAR(F[0], surface(p, state, F[1]), 1e-3) << "the return leaves 1e-9 k_h D = 4e-4 N/m";
    largest = std::max(largest, F[0]);
  }
  EXPECT_GT(state.disturbed, 3 * p.softening_length);
  EXPECT_LT(state.H, 0.75 * largest);
}

TEST(MacroElement, a_drag_is_the_same_to_both_sides)
{
  const Parameters p = sample_parameters();
  State right = started(p, 3000), left = right;
  for (int k = 0; k < 100; ++k) {
    const auto R = step(p, right, 0.003, 0.0005), L = step(p, left, -0.003, 0.0005);
    EXPECT_NEAR(R[0], -L[0], 1e-6);
    EXPECT_NEAR(R[1], L[1], 1e-6);
  }
}

TEST(MacroElement, a_berm_adds_to_the_drag_up_to_what_it_holds_and_waits_where_it_was_left)
{
  Parameters without = sample_parameters(), with = without;
  without.berm_rate = 0;
  State a = started(without, 2000), b = started(with, 2000);
  const auto drag = [&](Real way) {
    for (int k = 0; k < 200; ++k) step(without, a, way / 200, 0), step(with, b, way / 200, 0);
    return b.H - a.H;
  };
  // dR/du = rate w - R/length, to R = rate w length: 2e4 * 0.1 * 0.5 = 1000 N/m after many lengths. k_h delays it by R/k_h = 1.25 mm.
  EXPECT_NEAR(drag(0.5), 1000 * (1 - std::exp(-1.)), 10);
  EXPECT_NEAR(drag(3), 1000, 10);
  const Real back = drag(-1);
  EXPECT_LT(back, 0) << "ahead there is a new berm";
  EXPECT_NEAR(drag(0.85), 1000 * (1 - std::exp(-0.85 / 0.5)), 20) << "a new one, before the left one is reached";
  EXPECT_GT(drag(0.15), 1500) << "both";
}

TEST(MacroElement, stiffness_is_the_slope_of_the_force)
{
  const Parameters p = sample_parameters();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1, 1);
  int off = 0, all = 0;
  for (int path = 0; path < 100; ++path) {
    State state = started(p, 3000);
    double du = 0, dw = 0;
    for (int k = 0; k < 60; ++k) {
      if (k % 20 == 0) du = 0.0015 * part(random), dw = 4e-4 * part(random);
      double K[2][2];
      State next = state;
      step(p, next, du, dw, K);
      for (int j = 0; j < 2; ++j) {
        constexpr double h = 1e-8;
        State more = state, less = state;
        const auto F = step(p, more, du + (j == 0) * h, dw + (j == 1) * h), G = step(p, less, du - (j == 0) * h, dw - (j == 1) * h);
        for (int i = 0; i < 2; ++i, ++all) off += std::abs((F[i] - G[i]) / (2 * h) - K[i][j]) > 1e-3 * p.vertical_stiffness;
      }
      state = next;
    }
  }
  EXPECT_LT(off, all / 1000) << "but where a step just crosses a corner of the model";
}

TEST(MacroElement, small_steps_and_a_large_one_agree)
{
  const Parameters p = sample_parameters();
  State one = started(p, 3000), many = one;
  step(p, one, 0.2, 0.01);
  for (int k = 0; k < 1000; ++k) step(p, many, 0.2 / 1000, 0.01 / 1000);
  EXPECT_NEAR(one.H, many.H, 0.02 * std::abs(many.H)) << "a large step is divided to D/250";
  EXPECT_NEAR(one.V, many.V, 0.02 * many.V);
}

TEST(MacroElement, a_lifted_pipe_parts_and_carries_nothing)
{
  const Parameters p = sample_parameters();
  State state = started(p, 2000);
  step(p, state, 0, -0.3);
  EXPECT_EQ(state.V, 0);
  step(p, state, 0.05, 0);
  EXPECT_NEAR(state.H, 0, 1e-3);
}

TEST(MacroElement, refuses_what_makes_no_sense_and_leaves_the_state)
{
  const Parameters p = sample_parameters();
  Parameters wrong = p;
  wrong.peak_ratio = 0;
  EXPECT_EQ(berm_macro_element_check(&wrong), BERM_MACRO_ELEMENT_PARAMETERS);
  wrong = p;
  wrong.version = 0;
  EXPECT_EQ(berm_macro_element_check(&wrong), BERM_MACRO_ELEMENT_OTHER_VERSION);
  EXPECT_EQ(berm_macro_element_check(nullptr), BERM_MACRO_ELEMENT_NULL);
  State state;
  EXPECT_EQ(berm_macro_element_start(&p, 0, 0.1, 1e9, &state), BERM_MACRO_ELEMENT_INPUT) << "more than V0";
  state = started(p, 2000);
  const double by[2] = {std::numeric_limits<double>::quiet_NaN(), 0};
  double F[2] = {1, 2};
  EXPECT_EQ(berm_macro_element_step(&p, &state, by, F, nullptr), BERM_MACRO_ELEMENT_INPUT);
  EXPECT_EQ(state.u, 0);
  EXPECT_EQ(state.V, 2000);
  EXPECT_STREQ(berm_macro_element_error(BERM_MACRO_ELEMENT_INPUT), "a displacement or force is no number or too large");
}

}  // namespace
}  // namespace berm::macro_element::this_file
