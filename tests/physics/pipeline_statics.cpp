// SPDX-License-Identifier: BSD-3-Clause
// Lines at rest, whose deflections and forces are known: on springs, hung from a tension, heated, and the column of Euler.
#include "beam/answers.hpp"
#include "beam/step.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using namespace beam;

constexpr Real EI = 69.4e6, EA = 3.74e9, weight = 1500;
const Section section = {EI, EA, 330, 330, weight, 0.2};

Line even_line(Real length, int elements, std::vector<Plane> planes, const Section& of = section)
{
  return straight_line(graded_nodes(length / elements, length, 1, length, length), of, std::move(planes));
}

void set_all(std::vector<Real>& values, Real value)
{
  std::fill(values.begin(), values.end(), value);
}

// Half of an endless line on springs k, pressed at x = 0 by P (half of it on this half): y = P b/(2k), M = P/(4b), b^4 = k/(4 EI). Springs at nodes half a metre apart, b = 0.245/m, take the force of (b h)^2/6 of the moment from the point.
TEST(Winkler, beam_under_a_point_force_has_the_deflection_and_moment_of_hetenyi)
{
  constexpr Real k = 1e6, P = 1e4;
  const Real b = std::pow(k / (4 * EI), 0.25);
  Line line = even_line(60, 120, {Plane::lateral});
  hold(line, 0, EndCondition::symmetric);
  add_springs(line, Direction::lateral, LinearSpring{k}, lengths_of_nodes(line));
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  loads.force[line.across(Plane::lateral, 0)] = P / 2;
  find_equilibrium(line, loads, state, work);
  EXPECT_NEAR(state.displacement[line.across(Plane::lateral, 0)], P * b / (2 * k), 0.01 * P * b / (2 * k));
  EXPECT_NEAR(-moment(line, state, Plane::lateral, 0), P / (4 * b), 0.01 * P / (4 * b));
}

/// The compression at which the first way to buckle appears, by halving.
Real buckling_force(const Line& line, Real below, Real above)
{
  State state = state_of(line);
  Work work(line);
  for (int i = 0; i < 30; ++i) {
    const Real middle = (below + above) / 2;
    set_all(state.constrained_force, middle);
    (modes_below(line, state, 0, work) == 0 ? below : above) = middle;
  }
  return below;
}

// Cubic elements are too stiff by (pi h/L)^4/720.
TEST(Euler, column_between_pins_buckles_at_pi_squared_EI_over_L_squared)
{
  constexpr Real L = 40;
  for (const Plane plane : {Plane::lateral, Plane::vertical}) {
    Line line = even_line(L, 10, {plane});
    hold(line, 0, EndCondition::pinned);
    hold(line, line.nodes() - 1, EndCondition::pinned);
    const Real euler = pi * pi * EI / (L * L);
    EXPECT_NEAR(buckling_force(line, 0.5 * euler, 2 * euler), euler, 1e-4 * euler);
  }
}

// A long line chooses the wave length 2 pi (EI/k)^(1/4) = 18 m; of 400 m the ends cost less than a percent.
TEST(Euler, long_line_on_springs_buckles_at_two_roots_of_k_EI)
{
  constexpr Real k = 1e6;
  Line line = even_line(400, 400, {Plane::lateral});
  hold(line, 0, EndCondition::pinned);
  hold(line, line.nodes() - 1, EndCondition::pinned);
  add_springs(line, Direction::lateral, LinearSpring{k}, lengths_of_nodes(line));
  const Real known = 2 * std::sqrt(k * EI);
  EXPECT_NEAR(buckling_force(line, 0.5 * known, 2 * known), known, 0.01 * known);
}

// A heated line slides towards its free end: P(x) = mu W x, over l = P0/(mu W), by mu W l^2/(2 EA). Friction is mobilised over a tenth of a millimetre, of 0.3 m.
TEST(HeatedLine, slides_towards_its_free_end_by_mu_W_l_squared_over_2_EA)
{
  constexpr Real P0 = 1e6, resistance = 0.5 * weight;
  Line line = even_line(3000, 300, {Plane::lateral});
  hold(line, line.nodes() - 1, EndCondition::clamped);
  add_springs(line, Direction::axial, friction(resistance, 1e-4), lengths_of_nodes(line));
  for (Index i = 0; i < line.nodes(); ++i) line.held[line.across(Plane::lateral, i)] = 1;
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  set_all(loads.constrained_force, P0);
  find_equilibrium(line, loads, state, work);
  const Real l = P0 / resistance, slip = resistance * l * l / (2 * EA);
  EXPECT_NEAR(state.displacement[line.axial(0)], -slip, 0.01 * slip);
  EXPECT_NEAR(effective_force(line, state, 99), -resistance * 995, 0.01 * P0);
  EXPECT_NEAR(effective_force(line, state, 280), -P0, 0.001 * P0);
}

// Between level ends a and a depth below, a cable of weight w and horizontal tension T hangs as y = T/w (cosh(w x/T) - 1) from its touchdown; a line of small slopes as w x^2/(2T). At depth d its touchdown is
// x_t = sqrt(2 T d/w) from the end. Stiffness moves it by sqrt(EI/T) or so: EI is small here. The bed is as stiff as to sink by a millimetre.
TEST(Catenary, line_laid_from_a_height_touches_down_where_a_cable_of_small_slopes_does)
{
  constexpr Real T = 400e3, depth = 1;
  Section cable = section;
  cable.bending_stiffness = 1e4;
  Line line = even_line(120, 480, {Plane::vertical}, cable);
  hold(line, 0, EndCondition::pinned);
  hold(line, line.nodes() - 1, EndCondition::pinned);
  line.held[line.across(Plane::vertical, line.nodes() - 1)] = 0;
  add_springs(line, Direction::vertical, OneSidedSpring{weight / 1e-3}, lengths_of_nodes(line), -depth);
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  add_weight(line, loads);
  set_all(loads.constrained_force, -T);
  find_equilibrium(line, loads, state, work);
  const Real tension = effective_force(line, state, 0), touchdown = std::sqrt(2 * tension * depth / weight);
  EXPECT_GT(tension, T);
  Real measured = 0;  // the parabola's foot, from the line at half of its height
  for (Index i = 1; i < line.nodes() && measured == 0; ++i) {
    const Real above = state.displacement[line.across(Plane::vertical, i)] + depth;
    if (above < depth / 2) measured = line.x[i] + std::sqrt(2 * tension * above / weight);
  }
  EXPECT_NEAR(measured, touchdown, 0.01 * touchdown);
  for (Index i = 0; i < line.nodes(); ++i)
    if (line.x[i] < touchdown - 1) {
      const Real from = touchdown - line.x[i];
      EXPECT_NEAR(state.displacement[line.across(Plane::vertical, i)], weight * from * from / (2 * tension) - depth, 0.01 * depth);
    }
  EXPECT_NEAR(state.displacement[line.across(Plane::vertical, line.nodes() - 10)], -depth - 1e-3, 1e-5);
}

/// Shape of a column between pins that has buckled exactly: its compression over Euler's, and shortening and amplitude over its length, by the angle at its ends (Love 1927).
struct Elastica {
  Real compression, shortening, amplitude;
};
Elastica elastica(Real end_angle)
{
  const Real m = std::sin(end_angle / 2), K = std::comp_ellint_1(m), E = std::comp_ellint_2(m);
  return {std::pow(2 * K / pi, 2), 2 - 2 * E / K, m / K};
}

// The same column, pushed together by the same part of its length, up to the slope for which the line is meant. The compression is 0.5 % too low, the amplitude 0.3 % too large, the moment right to 0.02 %.
TEST(VonKarman, column_that_has_buckled_to_the_largest_valid_slope_is_off_by_a_percent_at_most)
{
  constexpr Real L = 100;
  const Elastica exact = elastica(std::asin(largest_valid_slope));
  Section stiff = section;  // along the line, so that it gets shorter by bending alone
  stiff.axial_stiffness = 1e13;
  Line line = even_line(L, 20, {Plane::lateral}, stiff);
  hold(line, 0, EndCondition::pinned);
  hold(line, line.nodes() - 1, EndCondition::pinned);
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  const Real guess = 1.05 * exact.amplitude * L;
  for (Index i = 0; i < line.nodes(); ++i) {
    if (line.held[line.across(Plane::lateral, i)] == 0)
      state.displacement[line.across(Plane::lateral, i)] = guess * std::sin(pi * line.x[i] / L);
    state.displacement[line.across(Plane::lateral, i) + 1] = guess * pi / L * std::cos(pi * line.x[i] / L);
  }
  set_all(loads.constrained_force, stiff.axial_stiffness * exact.shortening);
  find_equilibrium(line, loads, state, work);
  const Real euler = pi * pi * EI / (L * L), amplitude = state.displacement[line.across(Plane::lateral, 10)];
  EXPECT_NEAR(largest_slope(line, state), largest_valid_slope, 0.01 * largest_valid_slope);
  EXPECT_NEAR(-effective_force(line, state, 0), exact.compression * euler, 0.01 * euler);
  EXPECT_NEAR(amplitude, exact.amplitude * L, 0.01 * exact.amplitude * L);
  EXPECT_NEAR(-moment(line, state, Plane::lateral, 10), exact.compression * euler * exact.amplitude * L,
              0.01 * euler * exact.amplitude * L);
}

}  // namespace
}  // namespace berm::this_file
