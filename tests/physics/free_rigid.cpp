// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies that move freely.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// A free cylinder of 0.4 m and 200 kg/m, 5 mm above an elastic bed of 2 m x 0.5 m on a fixed base.
settings::Case cylinder_over_bed()
{
  settings::Case c = elastic_box(2, {2, 1}, {40, 20}, 1e6, 0.3, 1000);
  bodies::BlockSettings bed;
  bed.center = {1, 0.25};
  bed.size = {2, 0.5};
  bed.spacing = 0.05 / 3;
  c.body[0].second.regions.clear();
  c.body[0].second.block = bed;
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  bodies::RigidSettings cylinder;
  cylinder.shape = bodies::CircleSettings{{1.01, 0.705}, 0.4};
  cylinder.mass = 200;
  cylinder.motion = bodies::Motion::free;
  c.rigid = {{"cylinder", cylinder}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "cylinder";
  c.contact = {{"contact", contact}};
  return c;
}

TEST(FreeCylinder, falls_as_gravity_says_until_it_touches)
{
  settings::Case c = cylinder_over_bed();
  c.gravity = {1, -10};
  c.contact.clear();
  Simulation<2> run(c);
  run.run_until(0.1);
  const bodies::RigidState<2>& cylinder = run.state().rigid_bodies[0];
  const Real t = run.state().time;
  EXPECT_NEAR((cylinder.velocity - t * Vec<2>(1, -10)).norm(), 0, 1e-12);
  // Each step moves it by the velocity at its end: g t dt / 2 too far.
  EXPECT_NEAR((cylinder.displacement - 0.5 * t * (t + run.state().dt) * Vec<2>(1, -10)).norm(), 0, 1e-4);
}

// Half a metre of air: 2 m/s for 20 ms, then gravity alone, 0.04 + 2 t + g t^2/2 after t more: 152.3 mm at 50 ms. The step moves it by the velocity at its end, g t dt/2 too far.
TEST(FreeCylinder, that_is_thrown_falls_on_from_the_speed_of_its_drive)
{
  settings::Case c = cylinder_over_bed();
  std::get<bodies::CircleSettings>(c.rigid[0].second.shape).center[1] = 1.2;
  c.gravity = {0, -9.81};
  settings::StageSettings& drive = c.stage[0];
  drive.kind = settings::StageKind::push;
  drive.velocity = 2;
  drive.until.time = 0.02;
  settings::StageSettings fall;
  fall.name = "fall";
  fall.until.time = 0.05;
  c.stage.push_back(fall);
  Simulation<2> run(c);
  run.run_until(0.02);
  const Real thrown = run.state().time;
  EXPECT_NEAR(run.state().rigid_bodies[0].displacement[1], -2 * thrown, 1e-12);
  ++run.state().stage.index;
  begin_stage(run.model(), run.state());
  run.run_until(0.07);
  const Real t = run.state().time - thrown;
  EXPECT_NEAR(run.state().rigid_bodies[0].displacement[1], -(2 * thrown + 2 * t + 9.81 / 2 * t * t), 9.81 * t * run.state().dt);
}

TEST(FreeCylinder, gives_the_bed_the_momentum_that_it_loses_and_energy_balances)
{
  settings::Case c = cylinder_over_bed();
  c.mpm.courant = 0.125;
  Simulation<2> run(c);
  bodies::RigidState<2>& cylinder = run.state().rigid_bodies[0];
  const bodies::RigidBody<2>& body = run.model().rigid_bodies[0];
  cylinder.velocity = {0, -0.5};
  const Real first = kinetic_energy(body, cylinder);
  Real worst = 0, slowest = infinity;
  run.run_until(0.15, [&] {
    const problem::Totals<2>& t = run.state().ledger.totals;
    const Real kinetic = mpm::sums_over(run.state().particles[0]).kinetic + kinetic_energy(body, cylinder);
    worst = std::max(worst, std::abs(kinetic + t.internal + t.friction + t.damping + t.filter - t.external - first));
    slowest = std::min(slowest, kinetic_energy(body, cylinder));
    // What the soil gave it by the step before is what it has got by now.
    const Vec<2> lost = 200 * (Vec<2>(0, -0.5) - cylinder.velocity),
                 given = run.state().ledger.contact_sums[0].impulse + run.state().dt * cylinder.reaction;
    EXPECT_NEAR((lost - given).norm(), 0, 1e-3 * 100);  // the last force acts over the next step, which is not quite as long
  });
  EXPECT_LT(worst, 0.02 * first);      // in proportion to the time step: 3.5 % with courant 0.5, 2.1 % with 0.25, 1.2 % with 0.125
  EXPECT_LT(slowest, 0.01 * first);    // it has come to rest,
  EXPECT_GT(cylinder.velocity[1], 0);  // and is on its way back
}

TEST(FreeCylinder, is_turned_by_friction_as_much_as_the_bed_is_turned_back)
{
  settings::Case c = cylinder_over_bed();
  std::get<bodies::CircleSettings>(c.rigid[0].second.shape).center[1] = 0.695;  // 5 mm in the bed: it is pressed from the start
  c.gravity = {2, -10};
  c.rigid[0].second.rotation = bodies::Rotation::free;
  c.contact[0].second.friction_angle = 0.2;
  Simulation<2> run(c);
  const bodies::RigidState<2>& cylinder = run.state().rigid_bodies[0];
  run.run_until(0.1);
  EXPECT_LT(cylinder.angular_velocity, -0.1);  // it goes along x on top of the bed, so it rolls clockwise
  // I times its spin, and the moment that its contacts gave to the bed, but for the last step's, which acts in the next.
  const Real lost = -run.model().rigid_bodies[0].inertia * cylinder.angular_velocity;
  EXPECT_NEAR(run.state().ledger.contact_sums[0].torque_impulse + run.state().dt * cylinder.torque, lost, 1e-3 * lost);
}

}  // namespace
}  // namespace berm::this_file
