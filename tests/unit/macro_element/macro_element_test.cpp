// SPDX-License-Identifier: BSD-3-Clause
#include "samples/macro_element_parameters.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace berm::macro_element::this_file {
namespace {

using State = berm_macro_element_state;

using Real = double;
enum { T, H, V };

/// A pipe at w = 0.1 m under V, N/m.
State started(const Parameters& p, Real V, Real w = 0.1)
{
  const double at[3] = {0, 0, w};
  State state{};
  EXPECT_EQ(berm_macro_element_start(&p, at, V, &state), BERM_MACRO_ELEMENT_OK);
  return state;
}

std::array<double, 3> step(const Parameters& p, State& state, double du, double dw, double dx = 0, double K[3][3] = nullptr)
{
  const double to[3] = {state.x + dx, state.u + du, state.w + dw};
  std::array<double, 3> F{};
  EXPECT_EQ(berm_macro_element_step(&p, &state, to, &state, F.data(), K), BERM_MACRO_ELEMENT_OK);
  return F;
}

/// The numbers of a state.
std::array<double, BERM_MACRO_ELEMENT_NUMBERS> numbers_of(const State& state)
{
  std::array<double, BERM_MACRO_ELEMENT_NUMBERS> numbers{};
  std::memcpy(numbers.data(), reinterpret_cast<const char*>(&state) + offsetof(State, x), sizeof numbers);
  return numbers;
}

TEST(MacroElement, a_push_follows_the_resistance_of_fresh_soil)
{
  const Parameters p = sample_parameters();
  State state = started(p, 0, 0);
  for (const Real w : {0.02, 0.05, 0.1, 0.25}) {
    const Real force = step(p, state, 0, w - state.w)[V];
    EXPECT_NEAR(force, 1.2e4 * std::sqrt(state.w_p / 0.5), 1e-6) << "V0 at the plastic embedment";
    EXPECT_NEAR(state.w - state.w_p, force / 1e6, 1e-12) << "the rest is elastic";
  }
}

TEST(MacroElement, inside_the_surface_it_is_elastic_and_nothing_stays)
{
  Parameters p = sample_parameters();
  p.berm_rate = 0;
  const State before = started(p, 2000);
  State state = before;
  double K[3][3];
  const auto F = step(p, state, 1e-4, -2e-4, 0, K);
  EXPECT_NEAR(F[H], 80, 1e-9);
  EXPECT_NEAR(F[V], 1800, 1e-9);
  EXPECT_DOUBLE_EQ(K[H][1], 8e5);
  EXPECT_DOUBLE_EQ(K[V][2], 1e6);
  EXPECT_DOUBLE_EQ(K[H][2], 0);
  EXPECT_DOUBLE_EQ(K[V][1], 0);
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
    EXPECT_NEAR(F[H], surface(p, state, F[V]), 1e-3) << "the return leaves 1e-9 k_h D = 4e-4 N/m";
    largest = std::max(largest, F[H]);
  }
  EXPECT_GT(state.disturbed, 3 * p.softening_length);
  EXPECT_LT(state.H, 0.75 * largest);
}

TEST(MacroElement, a_drag_is_the_same_to_both_sides)
{
  const Parameters p = sample_parameters();
  State right = started(p, 3000), left = right;
  for (int k = 0; k < 100; ++k) {
    const auto R = step(p, right, 0.003, 0.0005, 1e-4), L = step(p, left, -0.003, 0.0005, -1e-4);
    EXPECT_NEAR(R[T], -L[T], 1e-6);
    EXPECT_NEAR(R[H], -L[H], 1e-6);
    EXPECT_NEAR(R[V], L[V], 1e-6);
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
  Parameters p = sample_parameters();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1, 1);
  int off = 0, all = 0;
  for (int path = 0; path < 100; ++path) {
    State state = started(p, 3000);
    double du = 0, dw = 0, dx = 0;
    for (int k = 0; k < 60; ++k) {
      if (k % 20 == 0) du = 0.0015 * part(random), dw = 4e-4 * part(random);
      if (k % 10 == 0) dx = std::array{0., 0.0015, 1e-5}[path % 3] * part(random);
      double K[3][3];
      State next = state;
      step(p, next, du, dw, dx, K);
      for (int j = 0; j < 3; ++j) {
        constexpr double h = 1e-8;
        const double d[3] = {j == 0 ? h : 0, j == 1 ? h : 0, j == 2 ? h : 0};
        State more = state, less = state;
        const auto F = step(p, more, du + d[1], dw + d[2], dx + d[0]), G = step(p, less, du - d[1], dw - d[2], dx - d[0]);
        for (int i = 0; i < 3; ++i, ++all)
          off += std::abs((F[i] - G[i]) / (2 * h) - K[i][j]) > (i == T ? 1e-4 : 1e-3) * p.vertical_stiffness;
      }
      state = next;
    }
  }
  EXPECT_LT(off, all / 1000) << "but where a step just crosses a corner of the model";
}

TEST(MacroElement, is_a_pure_function_so_that_trial_steps_leave_nothing)
{
  const Parameters p = sample_parameters();
  State state = started(p, 3000);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int k = 0; k < 50; ++k) {
    const State before = state;
    const double to[3] = {state.x + 1e-3 * part(random), state.u + 0.02 * part(random), state.w + 1e-3 * part(random)};
    State first = before, second = before;
    std::array<double, 3> F{}, G{}, none{};
    double K[3][3], L[3][3];
    ASSERT_EQ(berm_macro_element_step(&p, &before, to, &first, F.data(), K), BERM_MACRO_ELEMENT_OK);
    for (const double far : {0.3, -0.3}) {
      const double trial[3] = {far, state.u + far, state.w + far};
      State there = before;
      ASSERT_EQ(berm_macro_element_step(&p, &before, trial, &there, none.data(), nullptr), BERM_MACRO_ELEMENT_OK);
    }
    ASSERT_EQ(berm_macro_element_step(&p, &before, to, &second, G.data(), L), BERM_MACRO_ELEMENT_OK);
    EXPECT_EQ(F, G);
    EXPECT_EQ(std::memcmp(K, L, sizeof K), 0);
    EXPECT_EQ(numbers_of(first), numbers_of(second));
    EXPECT_EQ(numbers_of(before), numbers_of(state)) << "what went before is not written to";
    ASSERT_EQ(berm_macro_element_step(&p, &state, to, &state, G.data(), nullptr), BERM_MACRO_ELEMENT_OK);
    EXPECT_EQ(numbers_of(first), numbers_of(state)) << "in place, too";
    EXPECT_EQ(state.x, to[0]);
    EXPECT_EQ(state.u, to[1]);
    EXPECT_EQ(state.w, to[2]);
  }
}

/// The normal force around the contact divided by V, as berm's formulas have it.
Real wedging(Real w_over_D)
{
  const Real b = std::acos(1 - 2 * std::min(w_over_D, 0.5));
  return 2 * std::sin(b) / (b + std::sin(b) * std::cos(b));
}

TEST(MacroElement, friction_along_the_pipe_grows_to_that_of_the_wedged_normal_force)
{
  const Parameters p = sample_parameters();
  for (const Real w : {1e-8, 1e-3, 0.1, 0.25, 0.3}) {
    State state = started(p, 0, w);
    step(p, state, 0, 1e-4);
    const Real R = 0.5 * wedging(state.w / 0.5) * state.V;
    EXPECT_NEAR(step(p, state, 0, 0, 0.001)[T], R / 4, 1e-6 * R) << "a quarter of the mobilisation";
    EXPECT_NEAR(step(p, state, 0, 0, 0.01)[T], R, 1e-6 * R);
    EXPECT_NEAR(step(p, state, 0, 0, -0.004)[T], 0, 1e-6 * R) << "back";
    EXPECT_NEAR(step(p, state, 0, 0, -1)[T], -R, 1e-6 * R);
    EXPECT_NEAR(state.H, 0, 4e-4) << "the return leaves 1e-9 k_h D";
  }
}

TEST(MacroElement, friction_that_the_normal_force_does_not_hold_any_more_is_lost)
{
  const Parameters p = sample_parameters();
  State state = started(p, 4000);
  const Real all = step(p, state, 0, 0, 0.1)[T];
  EXPECT_LT(step(p, state, 0, -0.002)[T], 0.6 * all) << "V is 2000 N/m";
  const Real held = state.T;
  EXPECT_DOUBLE_EQ(step(p, state, 0, 0.002)[T], held) << "soil that is pressed on again does not push along";
  step(p, state, 0, -0.3);
  EXPECT_EQ(state.T, 0) << "lifted";
  EXPECT_EQ(step(p, state, 0, 0, 1)[T], 0);
}

TEST(MacroElement, friction_opposes_the_sliding_so_that_a_pipe_dragged_across_slides_along_at_little_force)
{
  Parameters p = sample_parameters();
  p.flow_slope = 1e-6;  // it stays at its level
  State state = started(p, 3000);
  step(p, state, 0, 0, 0.1);
  EXPECT_NEAR(state.T, 0.5 * wedging(0.2) * state.V, 1e-6 * state.V);
  for (const Real ratio : {0.0, 0.1, 1.0, 10.0}) {
    for (int k = 0; k < 400; ++k) step(p, state, 0.001, 0, 0.001 * ratio);
    const Real R = 0.5 * wedging(state.w / 0.5) * state.V;
    EXPECT_NEAR(state.T, R * ratio / std::hypot(1, ratio), 0.01 * R) << "along: " << ratio << " of the way across";
  }
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
  const char* name = nullptr;
  EXPECT_EQ(berm_macro_element_check(&wrong, &name), BERM_MACRO_ELEMENT_PARAMETERS);
  EXPECT_STREQ(name, "peak_ratio");
  wrong = p;
  wrong.version = 0;
  EXPECT_EQ(berm_macro_element_check(&wrong, nullptr), BERM_MACRO_ELEMENT_OTHER_VERSION);
  EXPECT_EQ(berm_macro_element_check(nullptr, nullptr), BERM_MACRO_ELEMENT_NULL);
  State state = started(p, 2000);
  const double at[3] = {0, 0, 0.1};
  EXPECT_EQ(berm_macro_element_start(&p, at, 1e9, &state), BERM_MACRO_ELEMENT_INPUT) << "more than V0";
  for (int k = 0; k < 3; ++k) {
    double to[3] = {0, 0, 0.1};
    to[k] = std::numeric_limits<double>::quiet_NaN();
    double F[3] = {1, 2, 3};
    EXPECT_EQ(berm_macro_element_step(&p, &state, to, &state, F, nullptr), BERM_MACRO_ELEMENT_INPUT);
    EXPECT_EQ(F[0], 1);
    EXPECT_EQ(state.u, 0);
    EXPECT_EQ(state.V, 2000);
  }
  EXPECT_STREQ(berm_macro_element_error(BERM_MACRO_ELEMENT_INPUT), "a displacement or force is not a number or too large");
}

}  // namespace
}  // namespace berm::macro_element::this_file
