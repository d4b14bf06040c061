// SPDX-License-Identifier: BSD-3-Clause
#include "beam/energy.hpp"

#include "beam/step.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

const Section section = {2e6, 1e9, 100, 80, 0, 0.2};

TEST(Energy, of_a_line_that_moves_as_one_is_half_its_mass_times_the_squared_velocity)
{
  const Line line = straight_line({0, 1, 3, 7}, section, {Plane::lateral, Plane::vertical});
  State state = state_of(line);
  for (Index i = 0; i < line.nodes(); ++i) {
    state.velocity[line.axial(i)] = 2;
    state.velocity[line.across(Plane::lateral, i)] = 3, state.velocity[line.across(Plane::vertical, i)] = -1;
  }
  EXPECT_NEAR(kinetic_energy(line, state), 7 * (80 * 4 + 100 * 9 + 100) / 2., 1e-9);
}

TEST(Energy, of_a_bent_and_stretched_line_is_that_of_its_curvature_and_force)
{
  const Line line = straight_line({0, 1, 3, 7}, section, {Plane::lateral});
  State state = state_of(line);
  for (Index i = 0; i < line.nodes(); ++i) {  // v = c x^2/2, and u that takes the membrane's strain away but for a part
    const Real x = line.x[i], c = 0.01;
    state.displacement[line.across(Plane::lateral, i)] = c * x * x / 2, state.displacement[line.across(Plane::lateral, i) + 1] = c * x;
    state.displacement[line.axial(i)] = -c * c * x * x * x / 6 + 1e-4 * x;
  }
  EXPECT_NEAR(elastic_energy(line, state), 2e6 * 1e-4 / 2 * 7 + 1e9 * 1e-8 / 2 * 7, 1e-6);
}

// A force, heat, springs and damping together, while waves run along the line; steps are short against them.
TEST(Energy, changes_by_the_work_of_loads_and_heat_less_that_of_springs_and_damping)
{
  Line line = straight_line({0, 1, 2, 4, 6}, section, {Plane::lateral, Plane::vertical});
  hold(line, 0, EndCondition::clamped);
  add_springs(line, Direction::lateral, friction(300, 1e-3), lengths_of_nodes(line));
  add_springs(line, Direction::vertical, LinearSpring{2e4}, lengths_of_nodes(line));
  line.damping = {0.5, 2};
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  for (int i = 1; i <= 4000; ++i) {
    const Real t = 2.5e-4 * i;
    std::fill(loads.constrained_force.begin(), loads.constrained_force.end(), 1e5 * std::sin(3 * t));
    loads.force[line.across(Plane::lateral, 4)] = 3e3 * std::sin(5 * t);
    loads.force[line.across(Plane::vertical, 4)] = -1e3 * t;
    step(line, loads, 2.5e-4, state, work);
  }
  const Totals& totals = state.totals;
  EXPECT_GT(totals.work_on_springs, 10);
  EXPECT_GT(totals.damped, 0.1);
  const Real energy = kinetic_energy(line, state) + elastic_energy(line, state);
  EXPECT_NEAR(energy, totals.work_of_loads + totals.work_of_heat - totals.work_on_springs - totals.damped, 0.01 * totals.work_of_loads);
}

}  // namespace
}  // namespace berm::beam::this_file
