// SPDX-License-Identifier: BSD-3-Clause
// Natural frequencies of lines: counted by the modes below a frequency, and seen in the motion that time steps give.
#include "beam/energy.hpp"
#include "beam/step.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using namespace beam;

constexpr Real EI = 69.4e6, mass = 330, length = 40;
const Section section = {EI, 3.74e9, mass, mass, 1500, 0.2};

/// The angular frequency of the mode that `below` modes are slower than, by halving, rad/s.
Real natural_frequency(const Line& line, const State& state, Index below, Real largest)
{
  Work work(line);
  Real lower = 0, upper = largest;
  for (int i = 0; i < 40; ++i) {
    const Real middle = (lower + upper) / 2;
    (modes_below(line, state, middle, work) <= below ? lower : upper) = middle;
  }
  return lower;
}

/// The angular frequency at which a freedom swings after it was let go, rad/s: by the first and the last of some times at which it crosses zero upwards.
Real swinging_frequency(const Line& line, State state, Index freedom, Real dt, int periods)
{
  Work work(line);
  Loads loads = no_loads(line);
  loads.constrained_force = state.constrained_force;
  Real first = 0, last = 0;
  for (int crossings = 0; crossings <= periods;) {
    const Real before = state.displacement[freedom];
    step(line, loads, dt, state, work);
    const Real now = state.displacement[freedom];
    if (!(before < 0 && now >= 0)) continue;
    last = state.time - dt * now / (now - before);
    if (crossings++ == 0) first = last;
  }
  return 2 * pi * periods / (last - first);
}

Line even_line(int elements, Plane plane)
{
  return straight_line(graded_nodes(length / elements, length, 1, length, length), section, {plane});
}

// The roots of 1 + cos x cosh x = 0. Ten cubic elements have the first to 1e-5, the second to 1e-4.
TEST(Cantilever, has_the_frequencies_3_516_and_22_03)
{
  for (const Plane plane : {Plane::lateral, Plane::vertical}) {
    Line line = even_line(10, plane);
    hold(line, 0, EndCondition::clamped);
    for (Index i = 0; i < line.nodes(); ++i) line.held[line.axial(i)] = 1;
    const Real unit = std::sqrt(EI / (mass * std::pow(length, 4)));
    EXPECT_NEAR(natural_frequency(line, state_of(line), 0, 100 * unit), 3.51602 * unit, 1e-4 * unit);
    EXPECT_NEAR(natural_frequency(line, state_of(line), 1, 100 * unit), 22.0345 * unit, 1e-2 * unit);
  }
}

// Newmark's steps lengthen a period by the part (omega dt)^2/12 (1 + 12 (beta - 1/4)) or so: 0.1 % with 62 steps a period. The tip is let go from the deflection x^2 (3L - x), which is nearly that of the first mode.
TEST(Cantilever, swings_at_its_first_frequency)
{
  Line line = even_line(10, Plane::lateral);
  hold(line, 0, EndCondition::clamped);
  const Real omega = 3.51602 * std::sqrt(EI / (mass * std::pow(length, 4)));
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  const Index tip = line.across(Plane::lateral, line.nodes() - 1);
  loads.force[tip] = -0.1 * 3 * EI / std::pow(length, 3);
  find_equilibrium(line, loads, state, work);
  EXPECT_NEAR(state.displacement[tip], -0.1, 1e-4);  // P L^3/(3 EI), and slopes small enough
  EXPECT_NEAR(swinging_frequency(line, state, tip, 0.1 / omega, 5), omega, 0.005 * omega);
}

// omega^2 = (pi/L)^4 EI/m (1 - P/P_E): compression slows it down, tension makes it faster. Both ends are held along the line, so the amplitude is small: it makes tension of EA (pi y/L)^2/4.
TEST(ColumnBetweenPins, swings_more_slowly_under_compression)
{
  Line line = even_line(10, Plane::lateral);
  hold(line, 0, EndCondition::pinned);
  hold(line, line.nodes() - 1, EndCondition::pinned);
  const Real euler = pi * pi * EI / (length * length);
  for (const Real part : {-0.5, 0.0, 0.75}) {
    const Real omega = std::pow(pi / length, 2) * std::sqrt(EI / mass * (1 - part));
    State state = state_of(line);
    std::fill(state.constrained_force.begin(), state.constrained_force.end(), part * euler);
    EXPECT_NEAR(natural_frequency(line, state, 0, 10 * omega), omega, 1e-3 * omega);
    for (Index i = 0; i < line.nodes(); ++i) {
      const Index v = line.across(Plane::lateral, i);
      if (line.held[v] == 0) state.displacement[v] = 1e-3 * std::sin(pi * line.x[i] / length);
      state.displacement[v + 1] = 1e-3 * pi / length * std::cos(pi * line.x[i] / length);
    }
    EXPECT_NEAR(swinging_frequency(line, state, line.across(Plane::lateral, 5), 0.1 / omega, 5), omega, 0.005 * omega);
  }
}

}  // namespace
}  // namespace berm::this_file
