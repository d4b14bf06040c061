// SPDX-License-Identifier: BSD-3-Clause
#include "problem/rigid_contact.hpp"

#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real step_size = 1e-4;  // s

bodies::RigidSettings disk(Real x, Real y, Real mass)
{
  bodies::RigidSettings rigid;
  rigid.shape = bodies::CircleSettings{{x, y}, 0.2};
  rigid.mass = mass;
  rigid.motion = bodies::Motion::free;
  rigid.rotation = bodies::Rotation::free;
  return rigid;
}

/// Two bodies, "left" and "right", far above an elastic box.
settings::Case two_bodies(const bodies::RigidSettings& left, const bodies::RigidSettings& right, Real friction_angle = 0,
                          Real restitution = 0)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::free)});
  c.rigid = {{"left", left}, {"right", right}};
  c.rigid_contact = {{"proximity", {"left", "right", friction_angle, restitution}}};
  return c;
}

/// The rigid bodies of a case alone.
struct Flight {
  Problem<2> problem;
  Model<2>& model = problem.model;
  State<2>& state = problem.state;

  explicit Flight(const settings::Case& c) : problem(build<2>(c, ".", ".")) { state.dt = step_size; }
  bodies::RigidState<2>& body(int k) { return state.rigid_bodies[k]; }
  Real mass(int k) const { return model.rigid_bodies[k].mass; }
  void run(int steps)
  {
    for (int n = 0; n < steps; ++n) {
      drive_rigids(model, state, step_size);
      move_rigids(model, state);
      state.time += step_size;
    }
  }
  Vec<2> momentum() { return mass(0) * body(0).velocity + mass(1) * body(1).velocity; }
  /// About the origin.
  Real angular_momentum()
  {
    Real sum = 0;
    for (int k = 0; k < 2; ++k)
      sum += mass(k) * bodies::moment_of(center_now(model.rigid_bodies[k], body(k)), body(k).velocity) +
             model.rigid_bodies[k].inertia * body(k).angular_velocity;
    return sum;
  }
  Real energy() { return kinetic_energy(model.rigid_bodies[0], body(0)) + kinetic_energy(model.rigid_bodies[1], body(1)); }
};

// m1 v1 + m2 v2 is kept, and they part with e times the speed at which they met.
TEST(RigidContact, of_two_disks_head_on_keeps_momentum_and_has_the_restitution_asked_for)
{
  for (const Real e : {0., 0.3, 1.}) {
    Flight flight(two_bodies(disk(0.5, 3, 2), disk(1, 3, 3), 0, e));
    flight.body(0).velocity = {4, 0.5}, flight.body(1).velocity = {-1, 0.5};
    const Vec<2> momentum = flight.momentum();
    const Real energy = flight.energy(), angular = flight.angular_momentum();
    flight.run(2000);
    EXPECT_LE((flight.momentum() - momentum).norm(), 1e-13);
    EXPECT_NEAR(flight.angular_momentum(), angular, 1e-12);
    const Real common = (2 * 4 + 3 * -1) / 5.;
    EXPECT_NEAR(flight.body(0).velocity[0], common - 3 * e * 5 / 5, 1e-12) << e;
    EXPECT_NEAR(flight.body(1).velocity[0], common + 2 * e * 5 / 5, 1e-12) << e;
    EXPECT_NEAR(flight.state.ledger.totals.friction, energy - flight.energy(), 1e-12);
    EXPECT_NEAR(flight.state.ledger.totals.friction, (1 - e * e) * 0.5 * (2 * 3 / 5.) * 25, 1e-12);
    EXPECT_EQ(flight.state.ledger.totals.external, 0);
    EXPECT_NEAR(flight.state.ledger.rigid_impulses[0][0], -2 * (4 - flight.body(0).velocity[0]), 1e-12) << "on the first body";
  }
}

/// Three disks in a row, of which the first flies at the others.
settings::Case three_in_a_row(const std::array<Real, 3>& masses, Real gap, Real restitution)
{
  settings::Case c = two_bodies(disk(0.5, 3, masses[0]), disk(0.705, 3, masses[1]), 0, restitution);
  c.rigid.push_back({"last", disk(0.905 + gap, 3, masses[2])});
  c.rigid_contact.push_back({"next", {"right", "last", 0, restitution}});
  return c;
}

/// Their velocities once each pair that approaches has collided, one pair after the other.
std::array<Real, 3> one_pair_after_the_other(const std::array<Real, 3>& masses, Real restitution, Real speed)
{
  std::array<Real, 3> v{speed, 0, 0};
  for (bool again = true; again;) {
    again = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const Real approach = v[k] - v[k + 1], both = masses[k] + masses[k + 1];
      if (approach <= 1e-12) continue;
      v[k] -= masses[k + 1] / both * (1 + restitution) * approach;
      v[k + 1] += masses[k] / both * (1 + restitution) * approach;
      again = true;
    }
  }
  return v;
}

// In a step the first goes 2 mm: with the third 0.5 mm from the second both collisions are in one.
TEST(RigidContact, of_three_in_a_row_keeps_the_energy_of_collisions_within_one_step)
{
  for (const Real e : {0.5, 1.})
    for (const Real gap : {0.5e-3, 50e-3})
      for (const std::array<Real, 3>& masses : {std::array<Real, 3>{1, 1, 1}, {3, 1, 2}}) {
        Flight flight(three_in_a_row(masses, gap, e));
        flight.body(0).velocity = {20, 0};
        flight.run(1000);
        const std::array<Real, 3> expected = one_pair_after_the_other(masses, e, 20);
        Real lost = masses[0] * 20 * 20 / 2;
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(flight.body(k).velocity[0], expected[k], 1e-10) << "body " << k << ", e " << e << ", gap " << gap;
          lost -= kinetic_energy(flight.model.rigid_bodies[k], flight.body(k));
        }
        EXPECT_NEAR(flight.state.ledger.totals.friction, lost, 1e-9);
        EXPECT_LE(e == 1 ? std::abs(lost) : 0, 1e-9);
      }
}

// Bodies that bounce rest on each other all the same: the weight of a step is no collision.
TEST(RigidContact, bears_a_stack_of_disks_that_bounce)
{
  settings::Case c = two_bodies(disk(1, 3.1, 2), disk(1, 3.3, 3), 0, 0.5);
  c.rigid.push_back({"floor", {}});
  c.rigid.back().second.shape = bodies::HalfPlaneSettings{{1, 3}, {0, 1}};
  c.rigid_contact.push_back({"ground", {"left", "floor", 0, 0.5}});
  c.gravity = {0, -10};
  Flight flight(c);
  flight.run(5000);
  for (int k = 0; k < 2; ++k) EXPECT_LE(flight.body(k).displacement.norm(), 1e-9);
  EXPECT_NEAR(flight.state.ledger.rigid_impulses[1][1], (2 + 3) * 10 * 0.5, 1e-6) << "the weight of both times the time";
}

// A disk that flies to and fro between two walls, many times in a step, goes through neither.
TEST(RigidContact, holds_a_disk_between_walls_that_it_hits_many_times_in_a_step)
{
  settings::Case c = two_bodies(disk(1, 3, 2), disk(0, 0, 1), 0, 1);
  c.rigid[1].second = {};
  c.rigid[1].second.shape = bodies::HalfPlaneSettings{{0.8999, 3}, {1, 0}};
  c.rigid.push_back({"wall", {}});
  c.rigid.back().second.shape = bodies::HalfPlaneSettings{{1.1001, 3}, {-1, 0}};
  c.rigid_contact.push_back({"other", {"left", "wall", 0, 1}});
  Flight flight(c);
  flight.body(0).velocity = {10, 0};
  for (int n = 0; n < 20; ++n) {
    flight.run(1);
    EXPECT_LE(std::abs(flight.body(0).displacement[0]), 1e-4 + 1e-12);
  }
  EXPECT_NEAR(flight.state.ledger.totals.friction, 2 * 10 * 10 / 2. - kinetic_energy(flight.model.rigid_bodies[0], flight.body(0)), 1e-9);
}

// A spinning disk meets an equal one at rest with v = 1 m/s: of the slip R omega a part mu (1 + e) v (1 + 2) is taken, 1 by translation and 2 by rotation of each solid
// disk, 1/m + R^2/(m R^2/2) each, of both; all of it where friction is enough.
TEST(RigidContact, rubs_by_coulombs_law_and_sticks_where_friction_is_enough)
{
  const auto meet = [](Real friction, Real turning) {
    Flight flight(two_bodies(disk(0.5, 3, 2), disk(0.8, 3, 2), std::atan(friction), 0));
    flight.body(0).velocity = {1, 0}, flight.body(0).angular_velocity = turning;
    const Real angular = flight.angular_momentum();
    flight.run(2000);
    EXPECT_NEAR(flight.angular_momentum(), angular, 1e-12);
    EXPECT_NEAR(flight.body(0).velocity[0], 0.5, 1e-12);
    return flight;
  };
  constexpr Real R = 0.1, normal = 0.5;  // impulse over mass
  // The impact acts up to a step before they touch, 1 m/s dt apart: by so much of R the lever is too long, and the slip with it.
  constexpr Real too_long = 2 * step_size / R;
  Flight slides = meet(0.2, 40);
  EXPECT_NEAR(slides.body(1).velocity[1], 0.2 * normal, 1e-12);
  EXPECT_NEAR(slides.body(0).velocity[1], -0.2 * normal, 1e-12);
  EXPECT_NEAR(slides.body(0).angular_velocity, 40 - 0.2 * normal * 2 / R, too_long * 0.2 * normal * 2 / R);
  Flight sticks = meet(2, 6);
  const Real slip = 6 * R, impulse = slip / 6;  // over mass
  EXPECT_NEAR(sticks.body(1).velocity[1], impulse, too_long * impulse);
  EXPECT_NEAR(sticks.body(0).angular_velocity, 6 - impulse * 2 / R, too_long * impulse * 2 / R);
}

// Impulse times the speed of what drives; half of it is lost. Where the driver would be free without its drive, its own kinetic energy is in the balance, too.
TEST(RigidContact, lets_a_driven_body_push_a_free_one_along_and_counts_its_work)
{
  for (const bodies::Motion motion : {bodies::Motion::driven, bodies::Motion::free}) {
    settings::Case c = two_bodies(disk(0.5, 3, 2), disk(0.8, 3, 3));
    settings::StageSettings drag = stage_of(settings::StageKind::drag);
    drag.velocity = 0.5;
    drag.vertical = settings::Vertical::fixed;
    drag.rigid = "left";
    c.rigid[0].second.motion = motion;
    c.rigid[0].second.rotation = bodies::Rotation::fixed;
    c.stage = {drag};
    Flight flight(c);
    flight.run(4000);
    EXPECT_NEAR(flight.body(0).velocity[0], 0.5, 1e-15);
    EXPECT_NEAR(flight.body(1).velocity[0], 0.5, 1e-12);
    EXPECT_NEAR(flight.body(1).displacement[0] - flight.body(0).displacement[0], -0.1, 1e-12) << "they touch";
    const Real own = motion == bodies::Motion::free ? 2 * 0.5 * 0.5 / 2 : 0;
    EXPECT_NEAR(flight.state.ledger.totals.external, own + 3 * 0.5 * 0.5, 1e-12);
    EXPECT_NEAR(flight.state.ledger.totals.friction, 3 * 0.5 * 0.5 / 2, 1e-12);
  }
}

bodies::RigidSettings box_on_floor(Real x, Real y)
{
  bodies::RigidSettings box = disk(0, 0, 5);
  box.shape = bodies::BoxSettings{{x, y}, {0.4, 0.2}};
  return box;
}

bodies::RigidSettings floor_under(Real angle)
{
  bodies::RigidSettings floor;
  floor.shape = bodies::HalfPlaneSettings{{1, 3}, {-std::sin(angle), std::cos(angle)}};
  return floor;
}

TEST(RigidContact, bears_a_box_at_rest_on_two_corners)
{
  settings::Case c = two_bodies(box_on_floor(1, 3.1), floor_under(0), std::atan(0.5));
  c.gravity = {0, -10};
  Flight flight(c);
  flight.run(5000);
  EXPECT_LE(flight.body(0).displacement.norm(), 1e-12);
  EXPECT_LE(std::abs(flight.body(0).orientation.angle), 1e-12);
  EXPECT_NEAR(flight.state.ledger.rigid_impulses[0][1], 5 * 10 * 0.5, 1e-9) << "its weight times the time";
}

// a = g (sin - mu cos), and none below the friction angle. Under a sideways load the box would tip; here gravity is turned instead of the floor.
TEST(RigidContact, lets_a_box_slide_down_a_slope_as_friction_has_it)
{
  for (const Real mu : {0.2, 0.6}) {
    settings::Case c = two_bodies(box_on_floor(1, 3.1), floor_under(0), std::atan(mu));
    c.gravity = {10 * std::sin(0.4), -10 * std::cos(0.4)};
    c.rigid[0].second.shape = bodies::BoxSettings{{1, 3.02}, {0.4, 0.04}};
    Flight flight(c);
    flight.run(5000);
    const Real expected = std::max(Real(0), 10 * (std::sin(0.4) - mu * std::cos(0.4))) * 0.5;
    EXPECT_NEAR(flight.body(0).velocity[0], expected, 1e-9) << mu;
    EXPECT_NEAR(flight.body(0).velocity[1], 0, 1e-9);
  }
}

TEST(RigidContact, stops_the_run_where_neither_body_gives_way)
{
  settings::Case c = two_bodies(disk(0.5, 3, 2), disk(0.8, 3, 3));
  settings::StageSettings drag = stage_of(settings::StageKind::drag);
  drag.velocity = 0.5;
  drag.rigid = "left";
  drag.vertical = settings::Vertical::fixed;
  for (auto& [name, rigid] : c.rigid) rigid.motion = bodies::Motion::driven;
  c.stage = {drag};
  Flight flight(c);
  flight.run(1990);  // 0.1 m are 2000 steps
  EXPECT_THROW(flight.run(20), RunError);
}

TEST(RigidContact, is_asked_for_where_bodies_without_one_come_to_overlap)
{
  settings::Case c = two_bodies(disk(0.5, 3, 2), disk(0.8, 3, 3));
  c.rigid_contact.clear();
  Flight flight(c);
  flight.body(0).velocity = {1, 0};
  flight.run(900);
  EXPECT_NO_THROW(refuse_overlap(flight.model, flight.state));
  flight.run(200);
  EXPECT_THROW(refuse_overlap(flight.model, flight.state), RunError);
}

TEST(RigidContact, refuses_bodies_that_overlap_at_the_start)
{
  const settings::Case with = two_bodies(disk(0.5, 3, 2), disk(0.69, 3, 3));
  EXPECT_THROW(build<2>(with, ".", "."), KeyError);
  settings::Case without = with;
  without.rigid_contact.clear();
  EXPECT_THROW(build<2>(without, ".", "."), KeyError);
  for (auto& [name, rigid] : without.rigid) rigid.motion = bodies::Motion::driven;
  EXPECT_NO_THROW(build<2>(without, ".", ".")) << "neither moves: parts of one structure";
}

}  // namespace
}  // namespace berm::problem::this_file
