// SPDX-License-Identifier: BSD-3-Clause
// In space: momentum, angular momentum and energy of what bodies do to a bed, whole and cut by planes of symmetry; and no particle in a body.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

// Some 1e3 additions of forces that nearly cancel: 1e-16 times their number, with a wide margin.
constexpr Real round_off = 1e-12;

material::MohrCoulomb soft_clay()
{
  material::MohrCoulomb law;
  law.density = 1600;
  law.young_modulus = 500e3;
  law.poisson_ratio = 0.45;
  law.cohesion = 2e3;
  return law;
}

/// A body that is pushed into a bed of clay at 0.2 m/s, then dragged. The bed is 0.4 m x 0.24 m x 0.4 m around
/// x = z = 0, of cells of 40 mm, or the part of it at x > 0, z > 0 that planes of symmetry leave.
settings::Case pushed_into_clay(const bodies::RigidShapeSettings& shape, const std::vector<std::string>& symmetry = {})
{
  settings::Case c;
  c.geometry = settings::Geometry::space;
  mesh::SeabedMesh bed;
  bed.length = 0.4, bed.width = 0.4, bed.depth = 0.24, bed.headroom = 0.12;
  bed.near_size = 0.04, bed.near_depth = 0.16, bed.near_height = 0.08;
  bed.near_left = -0.16, bed.near_right = 0.16, bed.near_back = -0.16, bed.near_front = 0.16;
  for (const std::string& axis : symmetry) {
    if (axis == "x")
      bed.length = 0.2, bed.left = 0, bed.near_left = 0;
    else
      bed.width = 0.2, bed.back = 0, bed.near_back = 0;
  }
  c.mesh = bed;
  c.symmetry = symmetry;
  c.gravity = {0, -standard_gravity, 0};
  c.surface = 0;
  c.material = {{"clay", soft_clay()}};
  bodies::BodySettings body;
  body.material = "clay";
  body.regions = {"near", "bed"};
  body.particles_per_cell = 1;
  body.k0 = 1;
  body.damping = 0.05;
  c.body = {{"clay", body}};
  bodies::RigidSettings rigid;
  rigid.shape = shape;
  rigid.mass = 5;
  c.rigid = {{"body", rigid}};
  contact::ContactSettings skin;
  skin.body = "clay";
  skin.rigid = "body";
  skin.adhesion = 1e3;
  skin.friction_angle = 0.2;
  c.contact = {{"skin", skin}};
  c.support = {{"base", {"base", {"x", "y", "z"}}},
               {"left", {"left", {"x"}}},
               {"right", {"right", {"x"}}},
               {"back", {"back", {"z"}}},
               {"front", {"front", {"z"}}}};
  settings::StageSettings push;
  push.name = "push";
  push.kind = settings::StageKind::push;
  push.velocity = 0.2;
  push.ramp = 4e-3;
  push.until.time = infinity;
  settings::StageSettings drag = push;
  drag.name = "drag";
  drag.kind = settings::StageKind::drag;
  drag.vertical = settings::Vertical::fixed;
  c.stage = {push};
  if (symmetry.empty() || symmetry.front() != "x") c.stage.push_back(drag);
  return c;
}

bodies::RigidShapeSettings ball()
{
  return bodies::SphereSettings{{0, 0.08, 0}, 0.16};
}
bodies::RigidShapeSettings pipe_with_ends()
{
  bodies::CylinderSettings pipe;
  pipe.center = {0, 0.06, 0};
  pipe.axis = {0, 0, 1};
  pipe.diameter = 0.12;
  pipe.length = 0.2;
  return pipe;
}
bodies::RigidShapeSettings cone()
{
  bodies::ProfileSettings cone;
  cone.x = {0, 0.08, 0.08, 0};
  cone.y = {0, 0.08, 0.3, 0.3};
  cone.position = {0, -0.06, 0};  // its tip is in the bed from the start: one that enters a single cell does hardly any work
  return cone;
}
bodies::RigidShapeSettings block_on_edge()
{
  bodies::BoxSettings box;
  box.center = {0, 0.0815, 0};
  box.size = {0.12, 0.12, 0.16};
  box.rotation = {0, 0, 0.5};
  return box;
}

const std::pair<const char*, bodies::RigidShapeSettings> shapes[] = {
    {"ball", ball()}, {"pipe", pipe_with_ends()}, {"cone", cone()}, {"block on its edge", block_on_edge()}};

/// The largest depth of a particle's centre in the body, m; negative where all are outside.
Real deepest(const Simulation<3>& run)
{
  const bodies::RigidShape<3> now = placed<3>(run.problem.model.rigid_bodies[0], run.problem.state.rigid_bodies[0]);
  Real depth = -infinity;
  for (const auto& p : all_particles(run.problem.state)) depth = std::max(depth, -surface_at<3>(now, p.x).distance);
  return depth;
}

/// What momentum, energy and particles of a push and a drag of so many steps each must fulfil.
void expect_balances(const settings::Case& c, int steps)
{
  Simulation<3> run(c);
  Real largest = 0, error = 0, depth = -infinity;
  const auto masses = [&] {
    std::vector<Real> all;
    for (const auto& p : all_particles(run.state())) all.push_back(p.mass);
    return all;
  };
  const std::vector<Real> mass = masses();
  for (std::size_t stage = 0; stage < c.stage.size(); ++stage) {
    if (stage > 0) next_stage(run);
    for (int n = 0; n < steps; ++n) {
      take_steps(run, 1);
      const problem::Totals<3>& t = run.state().ledger.totals;
      const Real balance = mpm::sums_over(run.state().particles[0]).kinetic + t.internal + t.damping + t.filter + t.friction - t.external;
      largest = std::max(largest, std::abs(t.external));
      error = std::max(error, std::abs(balance));
      depth = std::max(depth, deepest(run));
    }
    EXPECT_LT(mpm::momentum_error(run.state()), round_off) << c.stage[stage].name;
  }
  EXPECT_LT(error, 0.01 * largest);
  EXPECT_LT(depth, 0) << "a particle is in the body";
  EXPECT_EQ(masses(), mass);
  const problem::Totals<3>& t = run.state().ledger.totals;
  for (const Vec<3>& impulse : {t.gravity_impulse, t.contact_impulse, t.support_impulse}) EXPECT_GT(impulse.norm(), 0);
  EXPECT_LT(t.contact_impulse[1], 0);  // the body pushes the soil down
}

// As in the plane: a body that begins in the bed is wished in place there.
TEST(Space, soil_is_left_out_where_a_body_lies_at_the_start)
{
  bodies::CylinderSettings pile;
  pile.center = {0, 0, 0};
  pile.axis = {0, 1, 0};
  pile.diameter = 0.12, pile.length = 0.2;
  bodies::SphereSettings buried{{0, -0.1, 0}, 0.16};
  for (const bodies::RigidShapeSettings& shape : {bodies::RigidShapeSettings(pile), bodies::RigidShapeSettings(buried), cone()}) {
    const Simulation<3> whole(pushed_into_clay(ball())), run(pushed_into_clay(shape));
    EXPECT_LE(deepest(run), 0);  // a centre of a cell may lie on the surface
    const auto count = [](const Simulation<3>& of) { return of.problem.state.particles[0].size(); };
    EXPECT_LT(count(run), count(whole));
    EXPECT_GT(count(run), 0.8 * count(whole));
  }
}

TEST(Space, momentum_and_energy_balance_and_no_particle_is_in_a_body_that_is_pushed_and_dragged)
{
  for (const auto& [name, shape] : shapes) {
    SCOPED_TRACE(name);
    expect_balances(pushed_into_clay(shape), 150);
  }
}

TEST(Space, they_balance_in_a_half_and_in_a_quarter)
{
  for (const auto& [name, shape] : shapes) {
    SCOPED_TRACE(name);
    expect_balances(pushed_into_clay(shape, {"z"}), 150);
  }
  expect_balances(pushed_into_clay(ball(), {"x", "z"}), 200);
}

TEST(Space, momentum_is_kept_by_every_scheme_with_every_detection)
{
  for (const contact::Scheme scheme : {contact::Scheme::musl_coupled, contact::Scheme::musl_double, contact::Scheme::musl_single,
                                       contact::Scheme::hybrid_usl, contact::Scheme::usf, contact::Scheme::tied})
    for (const contact::Detection detection :
         {contact::Detection::particle, contact::Detection::gap, contact::Detection::distance, contact::Detection::overlap}) {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", detection " << static_cast<int>(detection));
      settings::Case c = pushed_into_clay(ball(), {"z"});
      c.contact[0].second.scheme = scheme;
      c.contact[0].second.detection = detection;
      Simulation<3> run(c);
      take_steps(run, 30);
      next_stage(run);
      take_steps(run, 10);
      EXPECT_LT(mpm::momentum_error(run.state()), round_off);
      EXPECT_LT(run.state().ledger.totals.contact_impulse[1], 0);
    }
}

/// What is left of the angular momentum and of the energy of a free elastic cube of 0.4 m after an eighth of a turn about a skew axis, in cells of this size.
struct Turned {
  Vec<3> before, after;
  Real energy;
};
Turned turned_cube(Real cell)
{
  settings::Case c = elastic_box(3, {1, 1, 1}, std::vector<Real>(3, 1 / cell), 1e6, 0.3, 1000);
  bodies::BlockSettings block;
  block.center = {0.5, 0.5, 0.5};
  block.size = {0.4, 0.4, 0.4};
  block.spacing = cell / 2;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  Simulation<3> run(c);
  const Vec<3> omega = 4 * Vec<3>(1, 2, -2) / 3;
  run.set_velocities([&](const Vec<3>& x, const Vec<3>&) { return Vec<3>(bodies::cross(omega, Vec<3>(x - Vec<3>::Constant(0.5)))); });
  const mpm::BodySums<3> before = mpm::sums_over(run.state().particles[0]);
  run.run_until(pi / 4 / omega.norm());
  const mpm::BodySums<3> after = mpm::sums_over(run.state().particles[0]);
  EXPECT_LT(after.momentum.norm() / std::sqrt(2 * after.mass * after.kinetic), round_off);
  return {before.angular_momentum(), after.angular_momentum(), after.kinetic / before.kinetic};
}

// Particles get the impulse of a node where they are and not where the node is, which differs at the rim of a body: angular momentum is lost there, the less the
// smaller the cells are. A cube has the same moment of inertia about any axis, so what is left has the direction of before.
TEST(Space, a_free_cube_that_turns_about_a_skew_axis_loses_angular_momentum_at_its_rim_only)
{
  const auto left = [](const Turned& t) { return t.after.dot(t.before) / t.before.squaredNorm(); };
  const Turned coarse = turned_cube(0.1), fine = turned_cube(0.05);
  EXPECT_GT(left(fine), 0.88);
  EXPECT_LT(left(fine), 1);
  EXPECT_LT(1 - left(fine), 0.7 * (1 - left(coarse)));
  EXPECT_LT(bodies::cross(fine.after, fine.before).norm() / fine.before.squaredNorm(), 0.02);
  EXPECT_GT(fine.energy, 0.88);
}

TEST(Space, a_free_ball_gets_the_angular_momentum_that_friction_gives)
{
  settings::Case c = pushed_into_clay(ball());
  std::get<bodies::SphereSettings>(c.rigid[0].second.shape).center[1] = 0.078;  // it is pressed from the start
  c.rigid[0].second.motion = bodies::Motion::free;
  c.rigid[0].second.rotation = bodies::Rotation::free;
  c.stage.resize(1);
  c.stage[0].kind = settings::StageKind::free;
  c.stage[0].velocity.reset();
  c.gravity = {3, -standard_gravity, 2};
  Simulation<3> run(c);
  const bodies::RigidState<3>& state = run.state().rigid_bodies[0];
  run.run_until(0.05);
  EXPECT_LT(state.angular_velocity[2], -0.1);  // it goes along x on top of the bed
  EXPECT_GT(state.angular_velocity[0], 0.1);   // and along z
  // I omega, and the moment that its contacts gave to the bed, but for the last step's, which acts in the next.
  const Vec<3> got = times_inertia(run.model().rigid_bodies[0], state, state.angular_velocity),
               given = run.state().ledger.contact_sums[0].torque_impulse + run.state().dt * state.torque;
  EXPECT_LT((got + given).norm(), 1e-3 * got.norm());
}

}  // namespace
}  // namespace berm::this_file
