// SPDX-License-Identifier: BSD-3-Clause
// Tractions, released supports and weight at the start of finite elements.
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

struct Loaded {
  FemProblem problem;
  LoadSteps steps;

  explicit Loaded(const settings::Case& c) : problem(fem_problem_of(c)), steps(problem.model, problem.state)
  {
    steps.find_first_equilibrium();
  }
  void to_end_of_stage()
  {
    do steps.advance();
    while (!stage_ended(problem.model.model, problem.state.state));
  }
  Real energy_error() const
  {
    const problem::Totals<2>& t = problem.state.state.ledger.totals;
    return (t.internal + t.friction - t.external) / t.external;
  }
  void expect_stress(int component, Real exact, Real tolerance) const
  {
    for (const auto& points : problem.state.points)
      for (const SoilPoint& point : points) EXPECT_NEAR(point.stress[component], exact, tolerance);
  }
};

settings::Case pressed_block()
{
  settings::Case c = block_of(elastic_soil());
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}, {"rest"}}}, {"base", {"bottom", {"y"}}}};
  boundary::TractionSettings load;
  load.boundary = "top";
  load.stress = {0, -6000};
  load.ramp = 0.5;
  c.traction = {{"load", load}};
  return c;
}

TEST(SideLoads, sum_up_to_traction_times_length_at_its_middle)
{
  settings::Case c = pressed_block();
  c.traction[0].second.stress = {200, -600};
  c.traction[0].second.x_range = {0.1, 0.6};  // within sides of 0.25 m
  const FemProblem problem = fem_problem_of(c);
  Vec<2> force = Vec<2>::Zero();
  Real moment = 0, area = 0;
  for (const NodalLoad& load : problem.model.loads.at(0)) {
    force += load.force;
    moment += load.force[1] * problem.model.mesh.position[load.node][0];
    area += load.area;
  }
  EXPECT_NEAR((force - Vec<2>(100, -300)).norm(), 0, 1e-10);
  EXPECT_NEAR(moment / force[1], 0.35, 1e-12);
  EXPECT_NEAR(area, 0.5, 1e-12);
}

// Equilibrium is called what is left of a thousandth of the load.
constexpr Real of_iteration = 2e-3;

TEST(Traction, compresses_a_block_between_rollers_as_an_oedometer_does)
{
  Loaded block(pressed_block());
  block.to_end_of_stage();
  block.expect_stress(1, -6000, of_iteration * 6000);
  block.expect_stress(0, -6000. / 3, of_iteration * 6000);  // nu / (1 - nu)
  const NodalLoad& load = block.problem.model.loads[0][0];
  EXPECT_NEAR(block.problem.state.displacement[2 * load.node + 1] / (-6000 / oedometer_modulus * 0.5), 1, of_iteration);
  EXPECT_NEAR(block.energy_error(), 0, of_iteration);
}

TEST(ReleasedSupport, lets_its_reaction_go_and_the_block_settle_as_in_uniaxial_plane_strain)
{
  settings::Case c = pressed_block();
  c.stage.push_back(resting(1));
  c.stage[1].name = "released";
  Loaded block(c);
  block.to_end_of_stage();
  ASSERT_TRUE(block.steps.next_stage());
  block.to_end_of_stage();
  block.expect_stress(1, -6000, of_iteration * 6000);
  block.expect_stress(0, 0, of_iteration * 6000);
  block.expect_stress(2, -0.25 * 6000, of_iteration * 6000);
  const NodalLoad& load = block.problem.model.loads[0][0];
  const Real plane_modulus = 1e6 / (1 - 0.25 * 0.25);
  EXPECT_NEAR(block.problem.state.displacement[2 * load.node + 1] / (-6000 / plane_modulus * 0.5), 1, of_iteration);
  EXPECT_NEAR(block.energy_error(), 0, of_iteration);
  EXPECT_EQ(block.problem.state.initial_imbalance_factor, 0);
}

TEST(GravityLoading, is_the_k0_state_of_a_level_bed)
{
  for (const Real k0 : {0.4, 1., 1.4}) {
    settings::Case c = block_of(elastic_soil());
    c.gravity = {0, -10};
    c.body[0].second.k0 = k0;
    const FemProblem exact = fem_problem_of(c);
    c.initial_state = settings::InitialState::gravity_loading;
    const FemProblem found = fem_problem_of(c);
    for (Index cell = 0; cell < found.model.mesh.cell_count(); ++cell)
      for (int q = 0; q < triangle_points; ++q)
        for (int k = 0; k < 4; ++k)  // quadratic displacements hold the solution
          EXPECT_NEAR(found.state.points[cell][q].stress[k], exact.state.points[cell][q].stress[k], 1e-6);
  }
}

}  // namespace
}  // namespace berm::fem::this_file
