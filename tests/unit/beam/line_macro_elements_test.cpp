// SPDX-License-Identifier: BSD-3-Clause
#include "beam/energy.hpp"
#include "beam/step.hpp"
#include "macro_element/under_force.hpp"
#include "os/error.hpp"
#include "samples/buckling_pipe.hpp"
#include "samples/macro_element_parameters.hpp"

#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

using Parameters = berm_macro_element_parameters;
using Soil = berm_macro_element_state;

constexpr Real weight = 1500, laid_by = 2500;  // N/m

Soil soil_under_the_line(const Parameters& p)
{
  return macro_element::laid(p, laid_by, weight);
}

/// A line that cannot bend or stretch by itself: it moves as it is led along and sideways, and is free upwards.
struct Led {
  Parameters p = macro_element::sample_parameters();
  Line line;
  explicit Led(std::vector<Plane> planes) : line(straight_line({0, 1, 3}, {69.4e6, 3.74e9, 330, 330, weight, 0.2}, std::move(planes)))
  {
    add_macro_elements(line, p, lengths_of_nodes(line), soil_under_the_line(p));
    for (Index i = 0; i < line.nodes(); ++i)
      for (const Index held :
           {line.axial(i), line.across(Plane::lateral, i), line.across(Plane::lateral, i) + 1, line.across(Plane::vertical, i) + 1})
        line.held[held] = 1;
  }
};

TEST(MacroElements, of_a_line_that_is_led_give_the_forces_of_the_macro_element_alone)
{
  for (Led led : {Led({Plane::lateral, Plane::vertical}), Led({Plane::vertical, Plane::lateral})}) {
    State state = state_of(led.line);
    Work work(led.line);
    Loads loads = no_loads(led.line);
    add_weight(led.line, loads);
    Soil alone = soil_under_the_line(led.p);
    for (int k = 1; k <= 80; ++k) {
      const Real x = 0.01 * std::sin(0.3 * k), u = 0.4 * std::sin(0.05 * k);
      for (Index i = 0; i < led.line.nodes(); ++i)
        state.displacement[led.line.axial(i)] = x, state.displacement[led.line.across(Plane::lateral, i)] = u;
      find_equilibrium(led.line, loads, state, work);
      alone = macro_element::moved_under(led.p, alone, x, u, weight);
      for (const Soil& soil : state.macro_elements) {
        EXPECT_NEAR(soil.T, alone.T, 1e-4 * weight) << "equilibrium leaves 1e-8 of the largest force, which k_v makes w";
        EXPECT_NEAR(soil.H, alone.H, 1e-4 * weight);
        EXPECT_NEAR(soil.w, alone.w, 1e-7);
        EXPECT_NEAR(soil.V, weight, 1e-3);
      }
      EXPECT_NEAR(state.displacement[led.line.across(Plane::vertical, 1)], soil_under_the_line(led.p).w - alone.w, 1e-7);
    }
    EXPECT_GT(std::abs(alone.H), 500);
    EXPECT_GT(alone.w, soil_under_the_line(led.p).w + 0.01) << "it has dug itself in";
  }
}

// The end of a long line that a growing force pulls sideways; a table spring with what the macro-element has at that weight.
TEST(MacroElements, pushed_ever_farther_are_table_springs_of_their_own_curve)
{
  const auto pulled = [](bool by_macro_elements) {
    Parameters p = macro_element::sample_parameters();
    p.residual_ratio = 1;  // a curve that only climbs
    p.flow_slope = 1e-6;   // a line that stays at its level, where each metre carries its weight
    Line line =
        straight_line(graded_nodes(0.5, 20, 1.1, 4, 120), {69.4e6, 3.74e9, 330, 330, weight, 0.2}, {Plane::lateral, Plane::vertical});
    const std::vector<Real> lengths = lengths_of_nodes(line);
    hold(line, line.nodes() - 1, EndCondition::clamped);
    line.held[line.across(Plane::vertical, line.nodes() - 1)] = 0;
    line.damping = {1, 1};
    if (by_macro_elements) {
      add_macro_elements(line, p, lengths, soil_under_the_line(p));
    } else {
      Backbone curve;
      Soil alone = soil_under_the_line(p);
      Real before = 0;
      for (const Real u : {0.0002, 0.0005, 0.001, 0.002, 0.004, 0.008, 0.015, 0.03, 0.06, 0.1, 0.2, 0.4, 0.8, 1.6}) {
        const int steps = 40;
        for (int k = 1; k <= steps; ++k) alone = macro_element::moved_under(p, alone, 0, before + (u - before) * k / steps, weight);
        before = u;
        curve.points.push_back({u, alone.H});
      }
      add_springs(line, Direction::lateral, PlasticSpring{curve}, lengths);
      add_springs(line, Direction::axial, friction(p.axial_friction * weight, p.axial_mobilisation), lengths);
      add_springs(line, Direction::vertical, LinearSpring{p.vertical_stiffness}, lengths, weight / p.vertical_stiffness);
    }
    State state = state_of(line);
    Work work(line);
    Loads loads = no_loads(line);
    add_weight(line, loads);
    constexpr Real dt = 0.05, pull = 1.3e4;
    for (int k = 1; k <= 800; ++k) {  // slowly against how the line swings
      loads.force[line.across(Plane::lateral, 0)] = pull * k / 800;
      step(line, loads, dt, state, work);
    }
    return test::crown_of(line, state);
  };
  const test::Crown macro = pulled(true), table = pulled(false);
  EXPECT_GT(table.amplitude, 0.3) << "far beyond what mobilises it";
  EXPECT_NEAR(macro.amplitude, table.amplitude, 0.01 * table.amplitude);
  EXPECT_NEAR(macro.moment, table.moment, 0.01 * table.moment);
}

// Waves along the line and across it, in steps that are short against them.
TEST(MacroElements, take_the_work_that_the_line_loses)
{
  Line line = straight_line({0, 1, 2, 4, 6}, {2e6, 1e9, 100, 80, weight, 0.2}, {Plane::lateral, Plane::vertical});
  const Parameters p = macro_element::sample_parameters();
  add_macro_elements(line, p, lengths_of_nodes(line), soil_under_the_line(p));
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  add_weight(line, loads);
  find_equilibrium(line, loads, state, work);
  const Real at_rest = elastic_energy(line, state) - state.totals.work_of_loads - state.totals.work_of_heat + state.totals.work_on_springs;
  for (int i = 1; i <= 4000; ++i) {
    const Real t = 2.5e-4 * i;
    loads.force[line.across(Plane::lateral, 4)] = 4e3 * std::sin(5 * t);
    loads.force[line.axial(4)] = 5e3 * std::sin(3 * t);
    loads.force[line.across(Plane::vertical, 4)] = -4e3 * t;
    step(line, loads, 2.5e-4, state, work);
  }
  const Totals& totals = state.totals;
  EXPECT_GT(totals.work_on_springs, 100);
  EXPECT_NEAR(kinetic_energy(line, state) + elastic_energy(line, state) - at_rest,
              totals.work_of_loads + totals.work_of_heat - totals.work_on_springs, 0.01 * totals.work_of_loads);
}

TEST(MacroElements, of_a_step_without_equilibrium_are_left_as_they_were)
{
  Led led({Plane::lateral, Plane::vertical});
  State state = state_of(led.line);
  Work work(led.line);
  Loads loads = no_loads(led.line);
  loads.force[led.line.across(Plane::vertical, 1)] = -1e9;
  const Soil before = state.macro_elements[1];
  EXPECT_THROW(find_equilibrium(led.line, loads, state, work), NoEquilibrium);
  EXPECT_EQ(state.macro_elements[1].w, before.w);
  EXPECT_EQ(state.macro_elements[1].V, before.V);
  loads.force[led.line.across(Plane::vertical, 1)] = nan;
  EXPECT_THROW(step(led.line, loads, 0.01, state, work), NoEquilibrium);
  EXPECT_EQ(state.macro_elements[1].w, before.w);
}

TEST(MacroElements, are_refused_on_a_line_of_one_plane_or_with_numbers_that_make_no_sense)
{
  Parameters p = macro_element::sample_parameters();
  const Soil soil = soil_under_the_line(p);
  Line flat = straight_line({0, 1}, {69.4e6, 3.74e9, 330, 330, weight, 0.2}, {Plane::lateral});
  EXPECT_THROW(add_macro_elements(flat, p, lengths_of_nodes(flat), soil), InputError);
  Line line = straight_line({0, 1}, {69.4e6, 3.74e9, 330, 330, weight, 0.2}, {Plane::lateral, Plane::vertical});
  EXPECT_NO_THROW(add_macro_elements(line, p, {1, 0}, soil));
  EXPECT_EQ(line.macro_elements.size(), 1u);
  p.diameter = 0;
  EXPECT_THROW(add_macro_elements(line, p, lengths_of_nodes(line), soil), InputError);
}

}  // namespace
}  // namespace berm::beam::this_file
