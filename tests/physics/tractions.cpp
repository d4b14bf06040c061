// SPDX-License-Identifier: BSD-3-Clause
// A traction gives the soil its force, moves with it, and is in the balances of momentum and energy.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real round_off = 1e-12;  // some hundred additions of forces

/// Soil in the lower left quarter of a box of 2 m x 2 m, free on all sides, with an oblique traction on its right side.
settings::Case free_soil()
{
  settings::Case c = elastic_box(2, {2, 2}, {8, 8}, 1e6, 0.3, 1000);
  c.body[0].second.regions = {"soil"};
  boundary::TractionSettings pull;
  pull.boundary = "side";
  pull.stress = {2000, 500};
  pull.ramp = 0.02;
  c.traction = {{"pull", pull}};
  return c;
}
mesh::Mesh<2> mesh_of_quarter(const settings::Case& c)
{
  mesh::Mesh<2> mesh = make_box<2>(std::get<mesh::BoxMesh>(c.mesh));
  mesh.region_names = {"soil", "space"};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell).maxCoeff() < 1 ? 0 : 1;
  mesh.boundary_names.push_back("side");
  mesh.boundary_nodes.emplace_back();
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.position[i][0] == 1 && mesh.position[i][1] <= 1) mesh.boundary_nodes.back().push_back(i);
  return mesh;
}

/// 0.15 s: the soil goes through more than a cell.
struct PulledSoil {
  problem::Problem<2> problem;
  mpm::Workspace<2> workspace;
  explicit PulledSoil(const settings::Case& c) : problem(problem::build<2>(c, mesh_of_quarter(c))), workspace(problem.model, problem.state)
  {
  }
  void run_until(Real end)
  {
    while (problem.state.time < end) step(problem.model, problem.state, workspace);
  }
};

TEST(Traction, accelerates_free_soil_by_its_force_over_the_mass)
{
  PulledSoil soil(free_soil());
  const Real end = 0.3;
  soil.run_until(end);
  const problem::State<2>& state = soil.problem.state;
  const Real t = state.time, of_force = t - 0.01;  // the ramp takes half of its own time away
  const mpm::BodySums<2> sums = mpm::sums_over(state.particles[0]);
  EXPECT_LT(mpm::momentum_error(state), round_off);
  EXPECT_NEAR((state.ledger.totals.traction_impulse - of_force * Vec<2>(2000, 500)).norm() / 2000, 0, 2 * state.dt);
  EXPECT_NEAR((sums.momentum - of_force * Vec<2>(2000, 500)).norm() / sums.momentum.norm(), 0, 2 * state.dt / t);
}

TEST(Traction, does_the_work_that_the_soil_has)
{
  PulledSoil soil(free_soil());
  soil.run_until(0.3);
  const problem::State<2>& state = soil.problem.state;
  const Real kinetic = mpm::sums_over(state.particles[0]).kinetic;
  // The force moves by half of the square of the speed that it makes, and by what the soil stretches. The method loses some of the waves' energy.
  EXPECT_NEAR((kinetic + state.ledger.totals.internal) / state.ledger.totals.external, 1, 0.02);
  EXPECT_GT(state.ledger.totals.external, 0.9 * kinetic);
}

TEST(Traction, stays_with_the_soil_that_it_began_on_from_cell_to_cell)
{
  settings::Case c = free_soil();
  c.traction[0].second.stress = {0, 0};
  bodies::InitialVelocity motion;
  motion.amplitude = {1, 0.5};
  c.body[0].second.initial_velocity = {motion};
  PulledSoil soil(c);
  const auto first = soil.problem.state.load_points;
  soil.run_until(0.6);  // more than two cells
  const problem::State<2>& state = soil.problem.state;
  ASSERT_EQ(first.size(), 16u);
  for (std::size_t l = 0; l < first.size(); ++l) {
    EXPECT_NEAR((state.load_points[l].x - first[l].x - state.time * Vec<2>(1, 0.5)).norm(), 0, 1e-9);
    EXPECT_TRUE(locate(soil.problem.model.mesh, state.load_points[l].x, state.load_points[l].cell).cell == state.load_points[l].cell);
  }
}

TEST(Traction, goes_over_its_ramp_and_acts_in_its_stages_only)
{
  settings::Case c = free_soil();
  c.stage.push_back(c.stage[0]);
  c.stage[0].name = "with";
  c.stage[1].name = "without";
  c.traction[0].second.stages = {"with"};
  auto [model, state] = problem::build<2>(c, mesh_of_quarter(c));
  const auto part = [&](Real time) { return acting_fraction(model.tractions[0], state.tractions[0], time); };
  EXPECT_EQ(part(0), 0);
  EXPECT_NEAR(part(0.005), 0.25, 1e-15);
  EXPECT_EQ(part(1), 1);
  state.time = 0.01;  // half up
  state.stage.index = 1;
  begin_stage(model, state);
  EXPECT_NEAR(part(0.01), 0.5, 1e-15);
  EXPECT_NEAR(part(0.02), 0.25, 1e-15);
  EXPECT_NEAR(part(0.03), 0, 1e-15);
  state.time = 0.02;
  state.stage.index = 0;
  begin_stage(model, state);
  EXPECT_NEAR(part(0.02), 0.25, 1e-15);
}

TEST(Traction, is_the_same_to_the_last_bit_for_any_number_of_threads)
{
  const auto state_with = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    PulledSoil soil(free_soil());
    soil.run_until(0.1);
    omp_set_num_threads(before);
    return soil.problem.state;
  };
  const problem::State<2> one = state_with(1), three = state_with(3);
  for (std::size_t l = 0; l < one.load_points.size(); ++l) EXPECT_EQ(one.load_points[l].x, three.load_points[l].x);
  EXPECT_EQ(one.ledger.totals.traction_impulse, three.ledger.totals.traction_impulse);
  EXPECT_EQ(one.ledger.totals.external, three.ledger.totals.external);
}

}  // namespace
}  // namespace berm::this_file
