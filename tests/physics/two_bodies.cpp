// SPDX-License-Identifier: BSD-3-Clause
// Deformable bodies that touch each other.
#include "simulate.hpp"

#include "mpm/contact.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

bodies::BodySettings block_at(std::vector<Real> center, std::vector<Real> size, std::vector<Real> velocity)
{
  bodies::BodySettings body;
  body.material = "solid";
  bodies::BlockSettings block;
  block.center = center;
  block.size = size;
  block.spacing = 0.025;
  body.block = block;
  bodies::InitialVelocity motion;
  motion.amplitude = velocity;
  body.initial_velocity = {motion};
  return body;
}

contact::ContactSettings contact_between(const std::string& body, const std::string& other, Real friction_angle)
{
  contact::ContactSettings contact;
  contact.body = body;
  contact.other_body = other;
  contact.friction_angle = friction_angle;
  return contact;
}

/// Blocks in a box of 2 m x 1 m with cells of 0.1 m; E = 1 MPa, nu = 0.3, 1000 kg/m3.
settings::Case blocks(std::vector<std::pair<std::string, bodies::BodySettings>> bodies,
                      std::vector<std::pair<std::string, contact::ContactSettings>> contacts)
{
  settings::Case c = elastic_box(2, {2, 1}, {20, 10}, 1e6, 0.3, 1000);
  c.body = std::move(bodies);
  c.contact = std::move(contacts);
  return c;
}

settings::Case two_blocks_that_meet(Real friction_angle)
{
  // Rims 0.2 m apart, 2 m/s towards each other, and one of them slides past the other.
  return blocks({{"left", block_at({0.5, 0.5}, {0.4, 0.4}, {1, 0.3})}, {"right", block_at({1.15, 0.55}, {0.5, 0.3}, {-1, 0})}},
                {{"meeting", contact_between("left", "right", friction_angle)}});
}

Vec<2> momentum_of(const problem::State<2>& state, Index body)
{
  return mpm::sums_over(state.particles[body]).momentum;
}

TEST(TwoBodies, keep_their_momentum_to_round_off_through_a_collision_with_friction)
{
  Simulation<2> run(two_blocks_that_meet(0.3));
  const Vec<2> left = momentum_of(run.state(), 0), right = momentum_of(run.state(), 1);
  const Real size = left.norm() + right.norm();
  run.run_until(0.25);
  EXPECT_LT((momentum_of(run.state(), 0) + momentum_of(run.state(), 1) - left - right).norm(), 1e-12 * size);
  // What one got is what the contact says that it gave.
  EXPECT_LT((momentum_of(run.state(), 0) - left - run.state().ledger.pair_impulses[0]).norm(), 1e-12 * size);
  EXPECT_LT(momentum_of(run.state(), 0)[0], 0);  // it has been thrown back
  EXPECT_GE(run.state().ledger.totals.friction, 0);
}

TEST(TwoBodies, feel_nothing_of_each_other_before_their_rims_meet)
{
  // They meet after 0.1 s. With T = 20 dt the gap may begin to brake within 20 steps of that, 20 * 0.7 ms * 2 m/s = 0.03 m away.
  Simulation<2> run(two_blocks_that_meet(0.3));
  run.run_until(0.07);
  EXPECT_LT(run.state().ledger.pair_impulses[0].norm(), 1e-6 * momentum_of(run.state(), 1).norm());
  run.run_until(0.12);
  EXPECT_GT(run.state().ledger.pair_impulses[0].norm(), 0.05 * momentum_of(run.state(), 1).norm());
}

TEST(TwoBodies, swapped_give_the_same_motion)
{
  settings::Case c = two_blocks_that_meet(0.3), swapped = c;
  std::swap(swapped.contact[0].second.body, swapped.contact[0].second.other_body);
  Simulation<2> run(c), other(swapped);
  run.run_until(0.2);
  other.run_until(0.2);
  const Real size = momentum_of(run.state(), 0).norm();
  EXPECT_NEAR((momentum_of(run.state(), 0) - momentum_of(other.state(), 0)).norm() / size, 0, 1e-9);
  EXPECT_NEAR((run.state().ledger.pair_impulses[0] + other.state().ledger.pair_impulses[0]).norm() / size, 0, 1e-9);
}

/// The speed at which the sides of a contact point still approach each other faster than their gap allows, after the correction of step 4; m/s.
Real worst_approach(Simulation<2>& run)
{
  const problem::Model<2>& model = run.model();
  const problem::State<2>& state = run.state();
  Real worst = 0;
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    const auto velocity = [&](Index b, Index node) {
      const mpm::BodyGrid<2>& grid = run.workspace.grids[b];
      return Vec<2>(grid.velocity[node] + state.dt * grid.acceleration[node]);
    };
    for (const contact::ContactPoint<2>& point : run.workspace.contact_points[k].list) {
      const Index node = point.nodes[0];
      const Real approach = -(velocity(contact.body, node) - velocity(contact.other_body, node)).dot(point.normal);
      worst = std::max(worst, approach - std::max(Real(0), point.gap) / (contact.gap_closing_steps * state.default_dt));
    }
  }
  return worst;
}

TEST(ThreeBodies, that_meet_at_a_node_press_on_each_other_consistently)
{
  // Two blocks side by side, pushed together by 1 m/s, and a third that falls on both: at the nodes above the joint all three have mass.
  settings::Case c = blocks({{"left", block_at({0.75, 0.35}, {0.5, 0.3}, {1, 0})},
                             {"right", block_at({1.25, 0.35}, {0.5, 0.3}, {-1, 0})},
                             {"top", block_at({1.02, 0.65}, {0.5, 0.3}, {0, -1})}},
                            {{"joint", contact_between("left", "right", 0.3)},
                             {"left_top", contact_between("top", "left", 0.3)},
                             {"right_top", contact_between("top", "right", 0.3)}});
  Simulation<2> run(c);
  Vec<2> before = Vec<2>::Zero(), after = Vec<2>::Zero();
  for (Index b = 0; b < 3; ++b) before += momentum_of(run.state(), b);
  Index shared_by_three = 0;
  Real worst = 0;
  run.run_until(0.05, [&] {
    worst = std::max(worst, worst_approach(run));
    for (Index node = 0; node < run.model().mesh.node_count(); ++node) {
      const auto has = [&](Index b) { return run.workspace.grids[b].mass[node] > 0; };
      shared_by_three += has(0) && has(1) && has(2);
    }
  });
  for (Index b = 0; b < 3; ++b) after += momentum_of(run.state(), b);
  EXPECT_GT(shared_by_three, 0);
  EXPECT_LT((after - before).norm(), 1e-12 * before.norm());
  EXPECT_LT(worst, 0.002);  // m/s, of meetings at 1 m/s: ten sweeps leave 0.0005, one leaves 0.008
  for (const Vec<2>& impulse : run.state().ledger.pair_impulses) EXPECT_GT(impulse.norm(), 0.05 * before.norm());
}

TEST(BlockOnBlock, slides_with_the_friction_of_the_interface)
{
  // The lower block is held at its base by a plane with plenty of friction; gravity leans by 30 deg.
  settings::Case c = blocks({{"lower", block_at({1, 0.3}, {1.8, 0.2}, {0, 0})}, {"upper", block_at({0.6, 0.5}, {0.4, 0.2}, {0, 0})}},
                            {{"interface", contact_between("upper", "lower", std::atan(0.3))}});
  bodies::RigidSettings floor;
  floor.shape = bodies::HalfPlaneSettings{{0, 0.2}, {0, 1}};
  c.rigid = {{"floor", floor}};
  contact::ContactSettings base;
  base.body = "lower";
  base.rigid = "floor";
  base.friction_angle = 80 * pi / 180;
  c.contact.emplace_back("base", base);
  c.gravity = {5, -5 * std::sqrt(Real(3))};
  c.gravity_ramp = 0.1;
  Simulation<2> run(c);
  run.run_until(0.15);
  const auto velocity = [&] { return momentum_of(run.state(), 1)[0] / mpm::sums_over(run.state().particles[1]).mass; };
  const Real first = velocity(), begin = run.state().time;
  run.run_until(0.5);
  EXPECT_NEAR((velocity() - first) / (run.state().time - begin), 5 - 0.3 * 5 * std::sqrt(Real(3)), 0.01 * 2.4);
}

}  // namespace
}  // namespace berm::this_file
