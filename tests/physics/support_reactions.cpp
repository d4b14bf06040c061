// SPDX-License-Identifier: BSD-3-Clause
// The force of each support against statics, and against the impulse of all of them.
#include "pipe_in_sand.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

namespace berm::this_file {
namespace {

constexpr Real statics = 1e-3;
// Some 1e3 steps of forces that are summed in two orders.
constexpr Real round_off = 1e-11;
constexpr Real gravity = 10, density = 1000, k0 = 0.4;

/// A bed of 1 m x 0.5 m (in space 0.75 m wide) between smooth walls. Stress that is linear in each cell is in balance exactly; pressures that are averaged over
/// patches are not quite.
settings::Case bed(int dim)
{
  settings::Case c =
      dim == 2 ? elastic_box(2, {1, 0.5}, {8, 4}, 1e6, 0.2, density) : elastic_box(3, {1, 0.5, 0.75}, {4, 4, 3}, 1e6, 0.2, density);
  c.gravity = {0, -gravity, 0};
  c.gravity.resize(static_cast<std::size_t>(dim));
  c.surface = 0.5;
  c.body[0].second.k0 = k0;
  c.support = {{"base", {"bottom", {"y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  if (dim == 3) c.support.insert(c.support.end(), {{"front", {"front", {"z"}}}, {"back", {"back", {"z"}}}});
  c.mpm.volumetric_projection = false;
  c.output.support_reactions = true;
  return c;
}

/// The mean force of each support over the next `duration`, N/m or N.
template <int dim>
std::vector<Vec<dim>> mean_forces(Simulation<dim>& run, Real duration)
{
  const std::vector<Vec<dim>> before = run.state().ledger.support_impulses;
  const Real begin = run.state().time;
  run.run_until(begin + duration);
  std::vector<Vec<dim>> forces;
  for (std::size_t s = 0; s < before.size(); ++s)
    forces.push_back((run.state().ledger.support_impulses[s] - before[s]) / (run.state().time - begin));
  return forces;
}

template <int dim>
Vec<dim> sum_of_impulses(const problem::State<dim>& state)
{
  Vec<dim> sum = Vec<dim>::Zero();
  for (const Vec<dim>& impulse : state.ledger.support_impulses) sum += impulse;
  return sum;
}

TEST(SupportReactions, of_a_bed_at_rest_are_its_weight_and_its_thrust_on_smooth_walls)
{
  Simulation<2> run(bed(2));
  const std::vector<Vec<2>> forces = mean_forces(run, 0.1);
  const Real weight = density * gravity * 0.5, thrust = k0 * density * gravity * 0.5 * 0.5 / 2;
  EXPECT_NEAR(forces[0][1], weight, statics * weight);
  EXPECT_EQ(forces[0][0], 0);  // the base is smooth
  EXPECT_NEAR(forces[1][0], thrust, statics * thrust);
  EXPECT_NEAR(forces[2][0], -thrust, statics * thrust);
  EXPECT_EQ(forces[1][1], 0);
}

TEST(SupportReactions, of_a_bed_in_space_are_its_weight_and_its_thrust_on_four_walls)
{
  Simulation<3> run(bed(3));
  const std::vector<Vec<3>> forces = mean_forces(run, 0.05);
  const Real weight = density * gravity * 0.5 * 0.75, thrust = k0 * density * gravity * 0.5 * 0.5 / 2;  // of a metre of wall
  EXPECT_NEAR(forces[0][1], weight, statics * weight);
  EXPECT_NEAR(forces[1][0], 0.75 * thrust, statics * 0.75 * thrust);
  EXPECT_NEAR(forces[2][0], -0.75 * thrust, statics * 0.75 * thrust);
  EXPECT_NEAR(std::abs(forces[3][2]), thrust, statics * thrust);
  EXPECT_NEAR(forces[3][2] + forces[4][2], 0, statics * thrust);
}

// A quarter has a quarter of the weight, and the halves of two walls.
TEST(SupportReactions, of_a_quarter_are_those_of_its_part)
{
  settings::Case c = bed(3);
  c.symmetry = {"x", "z"};
  c.support = {{"base", {"bottom", {"y"}}}, {"right", {"right", {"x"}}}, {"front", {"front", {"z"}}}};
  Simulation<3> run(c);
  const std::vector<Vec<3>> forces = mean_forces(run, 0.05);
  const Real weight = density * gravity * 0.5 * 0.75, thrust = k0 * density * gravity * 0.5 * 0.5 / 2;
  EXPECT_EQ(run.model().parts, 4);
  EXPECT_NEAR(forces[0][1], weight, statics * weight);
  EXPECT_NEAR(forces[1][0], -0.75 * thrust, statics * 0.75 * thrust);
  // What no support holds, the planes of symmetry give.
  EXPECT_NEAR(sum_of_impulses(run.state())[1], run.state().ledger.totals.support_impulse[1],
              round_off * run.state().ledger.totals.support_impulse.norm());
}

// Per radian. The radial force of the wall is not the thrust times its length alone: hoop stress carries the rest of it in the soil.
TEST(SupportReactions, of_a_cylinder_of_soil_are_the_weight_and_the_pressure_on_the_wall_of_a_radian)
{
  settings::Case c = bed(2);
  c.geometry = settings::Geometry::axisymmetric;
  c.support.erase(c.support.begin() + 1);
  c.body[0].second.damping = 0.3;
  Simulation<2> run(c);
  run.run_until(1);
  const std::vector<Vec<2>> forces = mean_forces(run, 0.1);
  const Real weight = density * gravity * 0.5 / 2, thrust = k0 * density * gravity * 0.5 * 0.5 / 2;  // radius 1 m
  EXPECT_NEAR(forces[0][1], weight, statics * weight);
  EXPECT_NEAR(forces[1][0], -thrust, statics * thrust);
}

/// The bed without weight and stress on a rough base, under a stress along x on its right side (and down on its top).
settings::Case sheared_block(int dim)
{
  settings::Case c = bed(dim);
  c.gravity.clear();
  c.body[0].second.k0.reset();
  c.mpm.volumetric_projection = true;
  c.body[0].second.damping = 0.5;
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  if (dim == 3) c.support[0].second.fixed.emplace_back("z");
  boundary::TractionSettings side, top;
  side.boundary = "right";
  side.stress = {200, 0, 0};
  top.boundary = "top";
  top.stress = {0, -300, 0};
  for (boundary::TractionSettings* load : {&side, &top}) load->stress.resize(static_cast<std::size_t>(dim)), load->ramp = 0.2;
  c.traction = {{"side", side}, {"top", top}};
  return c;
}

TEST(SupportReactions, of_a_block_that_is_pushed_sideways_are_the_traction_times_the_area)
{
  Simulation<2> run(sheared_block(2));
  run.run_until(2);
  const std::vector<Vec<2>> forces = mean_forces(run, 0.1);
  EXPECT_NEAR(forces[0][0], -200 * 0.5, statics * 100);
  EXPECT_NEAR(forces[0][1], 300, statics * 300);
}

TEST(SupportReactions, of_a_block_in_space_are_the_traction_times_the_area)
{
  Simulation<3> run(sheared_block(3));
  run.run_until(2);
  const std::vector<Vec<3>> forces = mean_forces(run, 0.1);
  EXPECT_NEAR(forces[0][0], -200 * 0.5 * 0.75, statics * 75);
  EXPECT_NEAR(forces[0][1], 300 * 0.75, statics * 225);
  EXPECT_NEAR(forces[0][2], 0, statics * 75);
}

TEST(SupportReactions, around_an_axis_carry_what_presses_the_top_of_a_cylinder)
{
  settings::Case c = sheared_block(2);
  c.geometry = settings::Geometry::axisymmetric;
  c.traction.erase(c.traction.begin());
  Simulation<2> run(c);
  run.run_until(2);
  const std::vector<Vec<2>> forces = mean_forces(run, 0.1);
  EXPECT_NEAR(forces[0][1], 300 / 2., statics * 150);
}

TEST(SupportReactions, belong_at_a_corner_to_the_support_that_the_case_names_first)
{
  const auto forces_of = [](bool base_first) {
    settings::Case c = bed(2);
    c.support[0].second.fixed = {"x", "y"};
    if (!base_first) std::rotate(c.support.begin(), c.support.begin() + 1, c.support.end());
    Simulation<2> run(c);
    return mean_forces(run, 0.05);
  };
  const std::vector<Vec<2>> base_first = forces_of(true), walls_first = forces_of(false);
  const Real thrust = k0 * density * gravity * 0.5 * 0.5 / 2, height = 0.125;
  EXPECT_NEAR(walls_first[0][0], thrust, statics * thrust);
  // The lowest node of the wall has the stress of the lowest cells: of the triangle with a side there, half.
  const Real pressure = k0 * density * gravity * 0.5, corner = thrust - base_first[1][0];
  EXPECT_GT(corner, 0.9 * pressure * height / 2 * (1 - height / 0.5));
  EXPECT_LT(corner, pressure * height / 2);
  // The two corners of the base push against each other.
  EXPECT_NEAR(base_first[0][0], 0, statics * thrust);
}

TEST(SupportReactions, of_a_support_end_where_it_is_released)
{
  settings::Case c = bed(2);
  c.body[0].second.damping = 0.3;
  c.support[2].second.stages = {"held"};
  c.stage.push_back(c.stage[0]);
  c.stage[0].name = "held";
  c.stage[1].name = "released";
  Simulation<2> run(c);
  run.run_until(0.1);
  next_stage(run);
  run.run_until(2);
  const std::vector<Vec<2>> forces = mean_forces(run, 0.2);
  const Real thrust = k0 * density * gravity * 0.5 * 0.5 / 2;
  EXPECT_EQ(forces[2][0], 0);
  EXPECT_NEAR(forces[1][0], 0, 0.01 * thrust);  // nothing stands against it any more; it still swings a little
}

/// A block that a rough wall pushes over its base: points of contact at particles move nodes of the base, too; those at nodes only directions that nothing holds.
settings::Case pushed_block(contact::Scheme scheme, contact::Detection detection)
{
  settings::Case c = pipe_in_sand();
  c.rigid[0].second.shape = bodies::HalfPlaneSettings{{0.008, 0}, {1, 0}};
  c.body[0].second.block->center = {0.064, 0.02};
  c.body[0].second.block->size = {0.112, 0.04};
  c.contact[0].second.scheme = scheme;
  c.contact[0].second.detection = detection;
  c.support.erase(c.support.begin() + 1);
  c.stage.erase(c.stage.begin());
  c.stage[0].vertical = settings::Vertical::fixed;
  c.output.support_reactions = true;
  return c;
}

TEST(SupportReactions, add_up_to_the_impulse_of_all_supports_with_every_scheme)
{
  for (const contact::Scheme scheme : {contact::Scheme::musl_coupled, contact::Scheme::musl_double, contact::Scheme::musl_single,
                                       contact::Scheme::hybrid_usl, contact::Scheme::usf, contact::Scheme::tied})
    for (const contact::Detection detection : {contact::Detection::particle, contact::Detection::gap}) {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", detection " << static_cast<int>(detection));
      Simulation<2> run(pushed_block(scheme, detection));
      Vec<2> before_contact = Vec<2>::Zero();
      for (int n = 0; n < 200; ++n) {
        take_steps(run, 1);
        for (const Index node : run.workspace.grids[0].nodes)
          if (run.model().conditions.tables[0].held[node] != 0)
            before_contact += run.state().dt * run.workspace.grids[0].support_force[node];
      }
      const problem::Totals<2>& t = run.state().ledger.totals;
      const Real by_contact = (before_contact - t.support_impulse).norm() / t.support_impulse.norm();
      EXPECT_TRUE(detection == contact::Detection::particle ? by_contact > 1e-3 : by_contact < round_off) << by_contact;
      EXPECT_GT(t.contact_impulse[0], 0);
      EXPECT_LT(mpm::momentum_error(run.state()), round_off);
      EXPECT_LT((sum_of_impulses(run.state()) - t.support_impulse).norm(), round_off * t.support_impulse.norm());
      // Supports, contact, gravity and damping change the momentum, and nothing else does.
      const Vec<2> given = sum_of_impulses(run.state()) + t.contact_impulse + t.gravity_impulse + t.damping_impulse;
      EXPECT_LT((mpm::sums_over(run.state().particles[0]).momentum - t.first_momentum - given).norm(),
                round_off * t.support_impulse.norm());
    }
}

TEST(SupportReactions, add_up_to_the_impulse_of_all_supports_with_two_bodies_that_touch)
{
  settings::Case c = elastic_box(2, {2, 1}, {20, 10}, 1e6, 0.3, 1000);
  c.gravity = {1, -10};
  const auto block_at = [&](Real x, const char* name) {
    bodies::BodySettings body;
    body.material = "solid";
    bodies::BlockSettings block;
    block.center = {x, 0.2};
    block.size = {0.4, 0.4};
    block.spacing = 0.025;
    body.block = block;
    bodies::InitialVelocity motion;
    motion.amplitude = {x < 0.5 ? 1. : 0., 0};
    body.initial_velocity = {motion};
    return std::pair<std::string, bodies::BodySettings>(name, body);
  };
  c.body = {block_at(0.3, "west"), block_at(0.7, "east")};
  contact::ContactSettings contact;
  contact.body = "west";
  contact.other_body = "east";
  contact.friction_angle = 0.3;
  c.contact = {{"meeting", contact}};
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  c.output.support_reactions = true;
  Simulation<2> run(c);
  take_steps(run, 300);
  const Vec<2>& all = run.state().ledger.totals.support_impulse;
  EXPECT_GT(run.state().ledger.pair_impulses[0].norm(), 0.01 * all.norm());
  EXPECT_LT((sum_of_impulses(run.state()) - all).norm(), round_off * all.norm());
}

TEST(SupportReactions, are_the_same_bits_on_any_number_of_threads_and_change_no_others)
{
  const auto state_on = [](int threads, bool reported) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    settings::Case c = pushed_block(contact::Scheme::musl_coupled, contact::Detection::particle);
    c.output.support_reactions = reported;
    Simulation<2> run(c);
    take_steps(run, 100);
    omp_set_num_threads(before);
    return run.state();
  };
  const problem::State<2> one = state_on(1, true), several = state_on(3, true), unreported = state_on(1, false);
  for (std::size_t s = 0; s < one.ledger.support_impulses.size(); ++s)
    EXPECT_EQ(one.ledger.support_impulses[s], several.ledger.support_impulses[s]);
  EXPECT_TRUE(unreported.ledger.support_impulses.empty());
  EXPECT_EQ(one.ledger.totals.support_impulse, unreported.ledger.totals.support_impulse);
  EXPECT_EQ(one.ledger.totals.internal, unreported.ledger.totals.internal);
}

}  // namespace
}  // namespace berm::this_file
