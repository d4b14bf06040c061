// SPDX-License-Identifier: BSD-3-Clause
// The snap of a hot pipe: what it does with its energy.
#include "beam/energy.hpp"
#include "samples/buckling_pipe.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using namespace beam;

struct Snap {
  Real speed = 0;     ///< m/s, largest sideways
  Real work = 0;      ///< J, of heat
  Real friction = 0;  ///< J, taken by springs
  Real lost = 0;      ///< J, that no work accounts for
};

/// Heats a line with a small imperfection through its snap in steps of dt.
Snap snap(Real dt)
{
  const test::HotPipe pipe;
  Line line = test::bent_line(pipe, false, 0.15, 60, graded_nodes(1, 80, 1.15, 4, 400));
  add_springs(line, Direction::axial, friction(pipe.resistance(), pipe.mobilisation), lengths_of_nodes(line));
  add_springs(line, Direction::lateral, friction(pipe.resistance(), pipe.mobilisation), lengths_of_nodes(line));
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  Snap snap;
  for (const int steps = static_cast<int>(std::lround(20 / dt)); state.time < 20 - dt / 2;) {
    std::fill(loads.constrained_force.begin(), loads.constrained_force.end(),
              2.2e6 * static_cast<Real>(std::lround(state.time / dt) + 1) / steps);
    step(line, loads, dt, state, work);
    for (Index i = 0; i < line.nodes(); ++i) snap.speed = std::max(snap.speed, std::abs(state.velocity[line.across(Plane::lateral, i)]));
  }
  snap.work = state.totals.work_of_heat, snap.friction = state.totals.work_on_springs;
  snap.lost = state.totals.work_of_loads + snap.work - snap.friction - kinetic_energy(line, state) - elastic_energy(line, state);
  return snap;
}

// What is lost is what Newmark's scheme takes from waves that a step does not resolve, and falls with the step.
TEST(Snap, of_a_hot_pipe_keeps_its_energy)
{
  const Snap coarse = snap(0.02), fine = snap(0.005);
  EXPECT_GT(fine.speed, 1) << "it snaps";
  EXPECT_GT(fine.friction, 0.1 * fine.work);
  EXPECT_NEAR(fine.lost, 0, 0.005 * fine.friction);
  EXPECT_NEAR(coarse.lost, 0, 0.02 * coarse.friction);
  EXPECT_NEAR(coarse.friction, fine.friction, 0.02 * fine.friction) << "nor does it change what friction takes";
}

}  // namespace
}  // namespace berm::this_file
