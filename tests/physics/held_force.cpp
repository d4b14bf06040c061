// SPDX-License-Identifier: BSD-3-Clause
// A pipe that is pushed into clay and dragged on keeps the vertical force of the end of the push, whatever the time step and the cells.
#include "material/mohr_coulomb.hpp"
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real diameter = 0.5, velocity = 0.2, depth = 0.1;  // m, m/s, m

settings::Case pipe_in_clay(Real columns, Real courant)
{
  settings::Case c;
  mesh::BoxMesh box;
  box.lower = {-1.5, -1};
  box.size = {3, 1.5};
  box.cells = {columns, columns / 2};
  box.pattern = mesh::BoxPattern::criss_cross;
  c.mesh = box;
  c.surface = 0;
  c.gravity = {0, -9.81};
  material::MohrCoulomb clay;
  clay.density = 600;
  clay.inertia_density = 1600;
  clay.young_modulus = 1e6;
  clay.poisson_ratio = 0.45;
  clay.cohesion = 4000;
  c.material = {{"clay", clay}};
  bodies::BodySettings bed;
  bed.material = "clay";
  bed.block = bodies::BlockSettings{};
  bed.block->center = {0, -0.5};
  bed.block->size = {3, 1};
  bed.block->spacing = 1 / columns;
  bed.k0 = 1;
  bed.damping = 0.05;
  c.body = {{"bed", bed}};
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{0, diameter / 2}, diameter};
  pipe.mass = 200;
  c.rigid = {{"pipe", pipe}};
  contact::ContactSettings skin;
  skin.body = "bed";
  skin.rigid = "pipe";
  skin.adhesion = 1000;
  c.contact = {{"skin", skin}};
  c.support = {{"bottom", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"top", {"top", {"y"}}}};
  c.mpm.courant = courant;
  settings::StageSettings push, drag;
  push.kind = settings::StageKind::push;
  drag.kind = settings::StageKind::drag;
  push.name = "push";
  drag.name = "drag";
  push.velocity = drag.velocity = velocity;
  push.ramp = drag.ramp = 0.05;
  push.until.embedment = depth;
  drag.until.time = 1e9;
  c.stage = {push, drag};
  return c;
}

/// Mean force of the soil on the pipe upwards over a travel: impulse over time, N/m.
Real mean_V(Simulation<2>& run, Real travel)
{
  const auto impulse = [&] { return -run.state().ledger.contact_sums[0].impulse[1]; };
  const Real from = impulse(), begin = run.state().time;
  run.run_until(begin + travel / velocity);
  return (impulse() - from) / (run.state().time - begin);
}

// The truth is a straight line through the means over the last two hundredths of D. What differs from it: that the force bends, (s/2w)^2 = 0.06 %; and noise of coarse cells,
// of which means over D/100 are 2 % from a smooth curve.
TEST(HeldForce, of_a_drag_is_that_of_the_end_of_the_push_for_any_step_and_cells)
{
  for (const auto& [columns, courant] : {std::pair{16., 1.}, {16., 0.3}, {16., 0.1}, {32., 1.}, {32., 0.3}}) {
    Simulation<2> run(pipe_in_clay(columns, courant));
    const auto w = [&] { return travel_of(run.model(), run.state(), 0).w; };
    while (w() < depth - 0.02 * diameter) step(run.model(), run.state(), run.workspace);
    const Real before = mean_V(run, 0.01 * diameter), last = mean_V(run, depth - w());
    while (!stage_ended(run.model(), run.state())) step(run.model(), run.state(), run.workspace);
    const Real at_end = last + (last - before) / 2;
    ++run.state().stage.index;
    begin_stage(run.model(), run.state());
    EXPECT_NEAR(-run.state().stage.drive[1].to / at_end, 1, 0.02) << columns << " cells, courant " << courant;
    mean_V(run, 0.1 * diameter);
    EXPECT_NEAR(mean_V(run, 0.1 * diameter) / at_end, 1, 0.02) << columns << " cells, courant " << courant;
  }
}

}  // namespace
}  // namespace berm::this_file
