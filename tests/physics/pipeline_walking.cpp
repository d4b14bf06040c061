// SPDX-License-Identifier: BSD-3-Clause
// A line that is free at both ends and walks towards the end that pulls it, as it is heated and cooled.
#include "beam/step.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using namespace beam;

// Friction f that is mobilised all along: the line grows around L/2 - S/(2f) as it is heated, and shrinks around L/2 + S/(2f) as it is cooled, of a tension S at its far end. What lies between
// the two goes the same way both times, so that a cycle moves the line by
//
//   (P0 + S - f L) S / (EA f)
//
// (Carr, Sinclair and Bruton 2006, OTC 17945; derived from the balance above). In 40 s inertia adds 0.8 %; friction that gives way over 0.1 mm takes as much of each way; elements of 2.5 m place the still points within half of that, of 250 m between them.

TEST(Walking, towards_a_pull_is_that_of_rigid_friction)
{
  constexpr Real EA = 3.74e9, L = 1000, f = 600, S = 150e3, P0 = 2e6;
  Line line = straight_line(graded_nodes(2.5, L, 1, 2.5, L), {69.4e6, EA, 330, 330, 1500, 0.2}, {Plane::lateral});
  add_springs(line, Direction::axial, friction(f, 1e-4), lengths_of_nodes(line));
  for (Index i = 0; i < line.nodes(); ++i) line.held[line.across(Plane::lateral, i)] = line.held[line.across(Plane::lateral, i) + 1] = 1;
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  loads.force[line.axial(line.nodes() - 1)] = S;
  const auto bring_to = [&](Real P) {
    const Real from = loads.constrained_force.front();
    constexpr int steps = 2000;  // in 40 s: in ten inertia adds 3 %
    for (int k = 1; k <= steps; ++k) {
      std::fill(loads.constrained_force.begin(), loads.constrained_force.end(), from + (P - from) * k / steps);
      step(line, loads, 0.02, state, work);
    }
    return state.displacement[line.axial(line.nodes() / 2)];
  };
  Real last = 0, walked = 0;
  for (int cycle = 0; cycle < 2; ++cycle) {
    bring_to(P0);
    const Real cold = bring_to(0);
    walked = cold - last;
    last = cold;
  }
  const Real expected = (P0 + S - f * L) * S / (EA * f);
  EXPECT_NEAR(walked, expected, 0.02 * expected) << "in the second cycle";
  EXPECT_GT(expected, 0.1);
}

}  // namespace
}  // namespace berm::this_file
