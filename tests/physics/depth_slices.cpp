// SPDX-License-Identifier: BSD-3-Clause
// The force of the soil on a rigid body by depth.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real K0 = 0.5, gamma = 18e3, cell = 0.05;
constexpr int slices = 4;

/// A smooth wall at rest to the left of elastic soil 1 m high with nu / (1 - nu) = K0, on a smooth base; so soft that the contact gap, a hundredth of a millimetre, takes
/// no pressure.
settings::Case wall_at_rest()
{
  settings::Case c = elastic_box(2, {2, 1}, {40, 20}, 1e6, 1. / 3, 1800);
  mesh::BoxMesh box;
  box.lower = {-0.3, 0};
  box.size = {2.3, 1.2};
  box.cells = {46, 24};
  c.mesh = box;
  c.gravity = {0, -gamma / 1800};
  c.surface = 1;
  bodies::BodySettings& soil = c.body[0].second;
  soil.regions.clear();
  soil.block = bodies::BlockSettings{{1, 0.5}, {2, 1}, 0, 1. / 60};
  soil.k0 = K0;
  soil.damping = 0.7;
  c.support = {{"right", {"right", {"x"}}}, {"bottom", {"bottom", {"y"}}}};
  bodies::BoxSettings shape;
  shape.center = {-0.15, 0.5};
  shape.size = {0.3, 1};
  bodies::RigidSettings wall;
  wall.shape = shape;
  wall.depth_slices = slices;
  c.rigid = {{"wall", wall}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "wall";
  c.contact = {{"smooth", contact}};
  return c;
}

TEST(DepthSlices, have_the_pressure_at_rest_that_grows_with_depth)
{
  Simulation<2> run(wall_at_rest());
  run.run_until(0.2);
  const std::vector<Real> before = run.state().ledger.slice_impulses[0];
  const Real all_before = run.state().ledger.contact_sums[0].impulse[0], begin = run.state().time;
  run.run_until(0.3);
  const Real time = run.state().time - begin, all = (run.state().ledger.contact_sums[0].impulse[0] - all_before) / time;
  Real sum = 0;
  for (int k = 0; k < slices; ++k) {
    const Real force = (run.state().ledger.slice_impulses[0][k] - before[k]) / time;
    sum += force;
    // A contact hands a force to nodes up to a cell away: half a cell of depth, at most.
    EXPECT_NEAR(force, K0 * gamma * (k + 0.5) / slices / slices, K0 * gamma * cell / 2 / slices) << k;
  }
  EXPECT_NEAR(sum, all, 1e-9 * all);
  EXPECT_NEAR(all, K0 * gamma / 2, 0.02 * K0 * gamma / 2);
}

// The soil's height is 1 m and the wall as high: each slice is a quarter of it, and its shaft carries the adhesion over that.
TEST(DepthSlices, have_the_adhesion_of_a_wall_that_is_pushed_down)
{
  constexpr Real adhesion = 100;
  settings::Case c = wall_at_rest();
  c.contact[0].second.adhesion = adhesion;
  c.stage[0].kind = settings::StageKind::drive;
  c.stage[0].rigid = "wall";
  c.stage[0].drive.y.velocity = -0.05;
  Simulation<2> run(c);
  run.run_until(0.1);
  const std::vector<Real> before = run.state().ledger.slice_shaft_impulses[0];
  const Real all_before = run.state().ledger.contact_sums[0].shaft_impulse, begin = run.state().time;
  run.run_until(0.2);
  const Real time = run.state().time - begin, all = (run.state().ledger.contact_sums[0].shaft_impulse - all_before) / time;
  Real sum = 0;
  for (int k = 0; k < slices; ++k) {
    const Real force = (run.state().ledger.slice_shaft_impulses[0][k] - before[k]) / time;
    sum += force;
    // A contact hands a force to nodes up to a cell away: a cell of depth at each end of a slice, at most.
    EXPECT_NEAR(force, -adhesion / slices, 2 * adhesion * cell) << k;
  }
  EXPECT_NEAR(sum, all, 1e-9 * std::abs(all));
}

// Slices of 1 cm beside particles of 1.7 cm.
TEST(DepthSlices, have_no_holes_where_they_are_thinner_than_particles)
{
  constexpr int thin = 100;
  settings::Case c = wall_at_rest();
  c.rigid[0].second.depth_slices = thin;
  c.contact[0].second.adhesion = 100;
  c.stage[0].kind = settings::StageKind::drive;
  c.stage[0].rigid = "wall";
  c.stage[0].drive.y.velocity = -0.05;
  Simulation<2> run(c);
  run.run_until(0.2);
  Real sum = 0;
  for (int k = 0; k < thin; ++k) {
    const Real impulse = run.state().ledger.slice_shaft_impulses[0][k];
    sum += impulse;
    if (k >= 10) {
      EXPECT_LT(impulse, 0) << k;
    }
  }
  EXPECT_NEAR(sum, run.state().ledger.contact_sums[0].shaft_impulse, 1e-9 * std::abs(sum));
}

// Gravity comes up beside a wall that nothing moves, and the soil, which does not part from it, settles: adhesion times the height that is covered, within the 3 % that slip
// which trembles may lose (examples/downdrag).
TEST(DepthSlices, have_the_adhesion_of_soil_that_settles_along_a_wall_that_is_held)
{
  constexpr Real adhesion = 100, modulus = 120e3;  // of the soil where it cannot widen: 3/2 E with a Poisson's ratio of 1/3
  settings::Case c = wall_at_rest();
  c.material[0].second.get<material::LinearElastic>().young_modulus = modulus / 1.5;
  c.body[0].second.block = bodies::BlockSettings{{0.5, 0.5}, {1, 1}, 0, 1. / 80};
  mesh::BoxMesh& box = std::get<mesh::BoxMesh>(c.mesh);
  box.size = {1.3, 1.2};
  box.cells = {26, 24};
  std::get<bodies::BoxSettings>(c.rigid[0].second.shape).size = {0.3, 3};
  c.body[0].second.k0.reset();
  c.contact[0].second.adhesion = adhesion;
  c.contact[0].second.tension = infinity;
  c.gravity_ramp = 6;
  c.mpm.quadrature = settings::Quadrature::cut_cells;
  Simulation<2> run(c);
  run.run_until(4);
  const Real before = run.state().ledger.contact_sums[0].shaft_impulse, begin = run.state().time;
  run.run_until(6);
  const Real x = gamma / modulus * 5 / 6, covered = (1 - std::exp(-x)) / x;
  EXPECT_NEAR((run.state().ledger.contact_sums[0].shaft_impulse - before) / (run.state().time - begin), adhesion * covered,
              0.03 * adhesion);
}

TEST(DepthSlices, are_refused_of_a_body_above_the_soil)
{
  settings::Case c = wall_at_rest();
  std::get<bodies::BoxSettings>(c.rigid[0].second.shape).center = {-0.15, 1.6};
  EXPECT_THROW(Simulation<2>{c}, InputError);
}

}  // namespace
}  // namespace berm::this_file
