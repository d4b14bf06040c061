// SPDX-License-Identifier: BSD-3-Clause
// An elastic block and a rigid plane.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// A block of 0.4 m x 0.4 m, 1000 kg/m3, whose lower rim is at y = 0.2 m, and a plane at y = level; cells of 0.1 m.
settings::Case block_over_plane(Real level)
{
  settings::Case c = elastic_box(2, {1, 1.5}, {10, 15}, 1e6, 0.2, 1000);
  bodies::BlockSettings block;
  block.center = {0.5, 0.4};
  block.size = {0.4, 0.4};
  block.spacing = 0.1 / 3;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  bodies::RigidSettings plane;
  plane.shape = bodies::HalfPlaneSettings{{0, level}, {0, 1}};
  plane.mass = 1;
  c.rigid = {{"plane", plane}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "plane";
  contact.friction_angle = 0.4;
  c.contact = {{"contact", contact}};
  return c;
}

TEST(Damping, does_not_act_at_the_contact_so_that_the_reaction_of_a_resting_block_is_its_weight)
{
  settings::Case c = block_over_plane(0.2);
  c.gravity = {0, -10};
  c.body[0].second.damping = 0.9;
  Simulation<2> run(c);
  run.run_until(4);
  const Real weight = 10 * mpm::sums_over(run.state().particles[0]).mass;
  EXPECT_NEAR(run.state().rigid_bodies[0].reaction[1] / -weight, 1, 1e-6);
  EXPECT_NEAR(run.state().rigid_bodies[0].reaction[0] / weight, 0, 1e-6);
}

TEST(Damping, hardly_adds_to_the_reaction_of_a_block_that_is_moved_at_constant_speed)
{
  // Damping opposes the motion by a part of the unbalanced forces inside, which are there only because particles cross cells. Where it acted on the
  // contact's nodes too, it would add its factor.
  const auto reaction_over_weight = [](Real factor) {
    settings::Case c = block_over_plane(0.2);
    c.gravity = {0, -10};
    c.body[0].second.damping = factor;
    c.stage[0].kind = settings::StageKind::push;
    c.stage[0].velocity = -0.1;  // upwards
    c.stage[0].ramp = 0.2;
    Simulation<2> run(c);
    run.run_until(1);
    const Real impulse = run.state().ledger.contact_sums[0].impulse[1], begin = run.state().time;
    run.run_until(3);
    return (run.state().ledger.contact_sums[0].impulse[1] - impulse) / (run.state().time - begin) /
           (10 * mpm::sums_over(run.state().particles[0]).mass);
  };
  EXPECT_NEAR(reaction_over_weight(0), 1, 0.002);
  EXPECT_NEAR(reaction_over_weight(0.1), 1, 0.06);
}

TEST(Bounce, energy_is_kept_stored_or_lost_at_the_contact)
{
  settings::Case c = block_over_plane(0.18);
  std::get<mesh::BoxMesh>(c.mesh).cells = {20, 30};
  c.body[0].second.block->spacing = 0.05 / 3;
  bodies::InitialVelocity motion;
  motion.amplitude = {0, -0.5};
  c.body[0].second.initial_velocity = {motion};
  Simulation<2> run(c);
  const Real first = mpm::sums_over(run.state().particles[0]).kinetic;
  Real worst = 0, last = 0;
  // Until it is on its way back: a second touch would be a collision of single nodes, whose loss the particles feel only in part.
  run.run_until(0.1, [&] {
    const auto now = mpm::sums_over(run.state().particles[0]);
    const problem::Totals<2>& t = run.state().ledger.totals;
    worst = std::max(worst, std::abs(now.kinetic + t.internal + t.friction + t.damping + t.filter - t.external - first));
    last = now.momentum[1];
  });
  EXPECT_LT(worst, 0.02 * first);
  EXPECT_GT(last, 0);  // it has turned round

  // What the material has stored is sigma : C^-1 : sigma / 2.
  constexpr Real young_modulus = 1e6, poisson_ratio = 0.2;
  Real stored = 0;
  for (const auto& p : all_particles(run.state()))
    stored += p.volume / (2 * young_modulus) *
              ((1 + poisson_ratio) * double_dot(p.stress, p.stress) - poisson_ratio * std::pow(trace(p.stress), 2));
  EXPECT_NEAR(run.state().ledger.totals.internal / first, stored / first, 0.01);
}

}  // namespace
}  // namespace berm::this_file
