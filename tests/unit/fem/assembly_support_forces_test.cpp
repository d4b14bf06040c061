// SPDX-License-Identifier: BSD-3-Clause
// Reactions of finite elements against statics.
#include "fem/assembly.hpp"

#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

constexpr Real statics = 1e-3;
constexpr Real gravity = 10, k0 = 0.4;

/// The block of 1 m x 0.5 m, at rest under its weight.
settings::Case bed_at_rest()
{
  settings::Case c = block_of(elastic_soil());
  c.gravity = {0, -gravity};
  c.body[0].second.k0 = k0;
  c.support[2].second.fixed = {"y"};
  c.output.support_reactions = true;
  return c;
}

std::vector<Vec<2>> forces_after_one_increment(const settings::Case& c)
{
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  while (!stage_ended(problem.model.model, problem.state.state)) steps.advance();
  return problem.state.support_forces;
}

TEST(SupportForces, of_a_bed_at_rest_are_its_weight_and_its_thrust_on_smooth_walls)
{
  const std::vector<Vec<2>> forces = forces_after_one_increment(bed_at_rest());
  const Real weight = 1000 * gravity * 0.5, thrust = k0 * weight * 0.5 / 2;
  ASSERT_EQ(forces.size(), 3u);
  EXPECT_NEAR(forces[0][0], thrust, statics * thrust);
  EXPECT_NEAR(forces[1][0], -thrust, statics * thrust);
  EXPECT_NEAR(forces[2][1], weight, statics * weight);
  EXPECT_EQ(forces[2][0], 0);
}

TEST(SupportForces, around_an_axis_are_those_of_a_radian)
{
  settings::Case c = bed_at_rest();
  c.geometry = settings::Geometry::axisymmetric;
  c.support.erase(c.support.begin());
  const std::vector<Vec<2>> forces = forces_after_one_increment(c);
  const Real weight = 1000 * gravity * 0.5 / 2, thrust = k0 * 1000 * gravity * 0.5 * 0.5 / 2;  // radius 1 m
  EXPECT_NEAR(forces[0][0], -thrust, statics * thrust);
  EXPECT_NEAR(forces[1][1], weight, statics * weight);
}

TEST(SupportForces, of_a_block_that_is_pushed_sideways_are_the_traction_times_the_area)
{
  settings::Case c = bed_at_rest();
  c.gravity.clear();
  c.body[0].second.k0.reset();
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  boundary::TractionSettings side, top;
  side.boundary = "right";
  side.stress = {200, 0};
  top.boundary = "top";
  top.stress = {0, -300};
  c.traction = {{"side", side}, {"top", top}};
  const std::vector<Vec<2>> forces = forces_after_one_increment(c);
  EXPECT_NEAR(forces[0][0], -200 * 0.5, statics * 100);
  EXPECT_NEAR(forces[0][1], 300, statics * 300);
}

TEST(SupportForces, and_the_force_of_a_rigid_body_carry_the_weight)
{
  settings::Case c = plate_on_block(plastic_soil(1e3, 0, 0), 0.4, {10, 5});
  c.gravity = {0, -gravity};
  c.body[0].second.k0 = 1;
  c.contact[0].second.friction_angle = 0.4;
  c.stage = {pushing()};
  c.stage[0].until.embedment = 0.01;
  c.output.support_reactions = true;
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  while (!stage_ended(problem.model.model, problem.state.state)) steps.advance();
  Vec<2> sum = -problem.state.state.rigid_bodies[0].reaction + problem.model.weight * Vec<2>(0, -1);
  for (const Vec<2>& force : problem.state.support_forces) sum += force;
  EXPECT_GT(problem.state.state.rigid_bodies[0].reaction[1], 1000);
  // The nodes that nothing holds are out of balance by as much.
  EXPECT_LE(sum.norm(), problem.state.unbalanced + 1e-9 * problem.model.weight);
}

TEST(SupportForces, are_not_there_where_they_are_not_asked_for)
{
  settings::Case c = bed_at_rest();
  c.output.support_reactions = false;
  EXPECT_TRUE(forces_after_one_increment(c).empty());
}

}  // namespace
}  // namespace berm::fem::this_file
