// SPDX-License-Identifier: BSD-3-Clause
#include "fem/newton.hpp"

#include "samples/critical_state_soils.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

FemLoads plate_moves_down_by(Real way)
{
  FemLoads loads;
  loads.rigid[1].value = -way;
  return loads;
}

TEST(Newton, solves_a_linear_problem_in_one_iteration_and_leaves_the_state_alone)
{
  FemProblem problem = fem_problem_of(plate_on_block(elastic_soil()));
  Newton newton(problem.model);
  std::vector<Real> change(problem.model.unknowns(), 0.);
  const IncrementEnd end = newton.find_equilibrium(problem.state, plate_moves_down_by(1e-3), 0, change);
  EXPECT_TRUE(end.converged);
  EXPECT_EQ(end.iterations, 1);
  EXPECT_LE(end.unbalance, problem.model.settings.tolerance);
  EXPECT_EQ(change[problem.model.rigid_unknown() + 1], -1e-3);
  EXPECT_GT(newton.assembly().reaction()[1], 1000);
  for (const Real u : problem.state.displacement) EXPECT_EQ(u, 0);
}

TEST(Newton, a_smooth_plate_on_rollers_finds_the_oedometer_modulus_less_the_contacts_springs)
{
  FemProblem problem = fem_problem_of(plate_on_block(elastic_soil()));
  problem.model.settings.tolerance = 1e-12;
  Newton newton(problem.model);
  std::vector<Real> change(problem.model.unknowns(), 0.);
  ASSERT_TRUE(newton.find_equilibrium(problem.state, plate_moves_down_by(1e-3), 0, change).converged);
  // In series: the block of 0.5 m, and springs with 100 times the stiffness of a layer as thick as the plate's sides of 0.25 m.
  const Real exact = 1e-3 / (0.5 / oedometer_modulus + 0.25 / (100 * oedometer_modulus));
  EXPECT_NEAR(newton.assembly().reaction()[1] / exact, 1, 1e-10);
  EXPECT_NEAR(newton.assembly().reaction()[0], 0, 1e-10 * exact);
  EXPECT_NEAR(newton.assembly().torque(), 0, 1e-10 * exact);
}

TEST(Newton, brings_yielding_soil_into_balance_within_the_tolerance)
{
  FemProblem problem = fem_problem_of(plate_on_block(plastic_soil(1e3, 0, 0), 0.5));
  for (const Real tolerance : {1e-3, 1e-9}) {
    problem.model.settings.tolerance = tolerance;
    Newton newton(problem.model);
    std::vector<Real> change(problem.model.unknowns(), 0.);
    const IncrementEnd end = newton.find_equilibrium(problem.state, plate_moves_down_by(2e-3), 1e-3, change);
    EXPECT_TRUE(end.converged);
    EXPECT_LE(newton.assembly().unbalanced(), tolerance * newton.assembly().contact_force());
  }
}

TEST(Newton, finds_the_equilibrium_of_soil_whose_matrix_is_unsymmetric)
{
  FemProblem problem = fem_problem_of(plate_on_block(sample_hypoplastic(), 0.5));
  ASSERT_TRUE(problem.model.unsymmetric);
  for (auto& points : problem.state.points)
    for (SoilPoint& point : points) point.stress = {{-2e4, -4e4, -2e4, 0}};
  FemLoads held;
  Newton newton(problem.model);
  newton.assembly().store_initial_imbalance(problem.state, held);
  problem.model.settings.tolerance = 1e-9;
  for (const Real down : {1e-5, 1e-4, 1e-3}) {
    FemLoads loads = plate_moves_down_by(down);
    loads.initial_imbalance_factor = 1;
    std::vector<Real> change(problem.model.unknowns(), 0.);
    const IncrementEnd end = newton.find_equilibrium(problem.state, loads, 0, change);
    EXPECT_TRUE(end.converged);
    // A matrix is kept while it leaves less than 0.3 of the unbalanced forces, 0.3^17 = 1e-9; some more where soil changes its branch.
    EXPECT_LE(end.iterations, 20) << down;
  }
}

TEST(Newton, says_that_there_is_no_equilibrium)
{
  // Nothing holds a plate that is pulled off.
  FemProblem problem = fem_problem_of(plate_on_block(elastic_soil()));
  Newton newton(problem.model);
  std::vector<Real> change(problem.model.unknowns(), 0.);
  FemLoads loads;
  loads.rigid[1] = {true, 100};
  const IncrementEnd end = newton.find_equilibrium(problem.state, loads, 0, change);
  EXPECT_FALSE(end.converged);
  EXPECT_GT(end.unbalance, problem.model.settings.tolerance);
}

}  // namespace
}  // namespace berm::fem::this_file
