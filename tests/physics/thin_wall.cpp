// SPDX-License-Identifier: BSD-3-Clause
// Why rigid bodies thinner than two cells are refused in soil of one body: contact takes the soil behind them along.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real cell = 0.05;

/// A smooth wall across the middle of elastic soil that is held at its right end and its base: to the right at 0.05 m/s.
settings::Case moved_wall(Real thickness)
{
  settings::Case c = elastic_box(2, {2, 0.5}, {40, 10}, 1e6, 0, 1600);
  c.surface = 0.5;
  c.body[0].second.damping = 0.1;
  c.support = {{"right", {"right", {"x"}}}, {"bottom", {"bottom", {"y"}}}};
  bodies::BoxSettings box;
  box.center = {1, 0.25};
  box.size = {thickness, 0.6};
  bodies::RigidSettings wall;
  wall.shape = box;
  wall.mass = 100;
  c.rigid = {{"wall", wall}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "wall";
  c.contact = {{"smooth", contact}};
  settings::StageSettings& stage = c.stage[0];
  stage.kind = settings::StageKind::drag;
  stage.velocity = 0.05;
  stage.vertical = settings::Vertical::fixed;
  stage.ramp = 0.1;
  return c;
}

Real left_end(const Simulation<2>& run)
{
  const bodies::Particles<2>& particles = run.problem.state.particles[0];
  Real least = infinity;
  particles.visit([&](Index, Index b, int l) { least = std::min(least, particles.read(b, l).x[0]); });
  return least;
}

/// Way of the free end of the soil behind the wall over that of the wall, 20 mm.
Real taken_along(Real thickness)
{
  Simulation<2> run(moved_wall(thickness));
  const Real begin = left_end(run);
  run.run_until(0.45);
  const Real part = (left_end(run) - begin) / run.state().rigid_bodies[0].displacement[0];
  printf("wall of %3.0f mm: %.2f\n", 1000 * thickness, part);
  return part;
}

// Nothing holds the soil to the wall, so that it must stay: 0. It goes along by more than half where both faces touch particles of cells with common nodes.
TEST(ThinWall, takes_the_soil_behind_it_along_where_it_is_thinner_than_two_cells)
{
  for (const Real thickness : {0.004, 0.025, 0.05, 0.075}) EXPECT_GT(taken_along(thickness), 0.5);
}

// To a hundredth: particles of a third of a cell are resolved to that at the most.
TEST(ThinWall, leaves_the_soil_behind_it_where_it_is_two_cells_thick_and_more)
{
  for (const Real thickness : {2 * cell, 3 * cell}) EXPECT_LT(std::abs(taken_along(thickness)), 0.01);
}

}  // namespace
}  // namespace berm::this_file
