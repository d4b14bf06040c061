// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/time_step.hpp"

#include "os/error.hpp"
#include "sample_problem.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

template <class Dimension>
class TimeStep : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(TimeStep, Dimensions);

TYPED_TEST(TimeStep, is_courant_times_the_least_height_over_the_speeds_of_wave_and_soil)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(0.2), 0);
  problem.model.mpm.courant = 0.4;
  // Only cells with particles count: the lowest one loses its particles.
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  Index lowest = 0;
  for (Index cell = 1; cell < mesh.cell_count(); ++cell)
    if (mesh.height(cell) < mesh.height(lowest)) lowest = cell;
  auto& particles = problem.state.particles[0];
  Real height = infinity;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (cell != lowest) height = std::min(height, mesh.height(cell));
  while (particles.count_in(lowest) > 0) particles.take(lowest, 0);
  particles.sort_occupied();
  ASSERT_GT(height, mesh.height(lowest));

  // M = E (1 - nu) / ((1 + nu)(1 - 2 nu)).
  const Real wave = std::sqrt(2e6 * 0.8 / (1.2 * 0.6) / 1500);
  Workspace<dim> workspace(problem.model, problem.state);
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.4 * height / wave), 1, 1e-14);

  workspace.grids[0].mapped_velocity[workspace.grids[0].nodes.back()] = 3 * Vec<dim>::UnitX() - 4 * Vec<dim>::UnitY();
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.4 * height / (wave + 5)), 1, 1e-14);

  problem.model.rigid_bodies.push_back({"pipe", make_shape<dim>(bodies::CircleSettings{std::vector<Real>(dim, 0), 0.5})});
  problem.state.rigid_bodies.emplace_back();
  problem.state.rigid_bodies[0].velocity = 7 * Vec<dim>::UnitX();
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.4 * height / (wave + 7)), 1, 1e-14);

  if constexpr (dim == 2)
    problem.state.rigid_bodies[0].angular_velocity = -8;
  else
    problem.state.rigid_bodies[0].angular_velocity = {0, 0, -8};
  // Its rim is 0.25 m away.
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.4 * height / (wave + 9)), 1, 1e-14);
}

TYPED_TEST(TimeStep, is_a_part_of_the_longest_stable_one_where_courant_is_not_set)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(0.2), 0);
  problem.model.mpm.courant.reset();
  problem.model.bodies[0].critical_length = 3;
  const Real wave = std::sqrt(2e6 * 0.8 / (1.2 * 0.6) / 1500);
  Workspace<dim> workspace(problem.model, problem.state);
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.75 * 3 / wave), 1, 1e-14);

  // Never less than half the time that a wave needs across the smallest cell with soil: smaller ones may lie elsewhere.
  problem.model.bodies[0].critical_length = 0;
  Real height = infinity;
  for (const Index cell : problem.state.particles[0].occupied()) height = std::min(height, problem.model.mesh.height(cell));
  EXPECT_NEAR(stable_time_steps(problem.model, problem.state, workspace).stable / (0.5 * height / wave), 1, 1e-14);
}

TYPED_TEST(TimeStep, by_default_is_the_same_whatever_courant_the_case_sets)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(0.2), 0);
  problem.model.bodies[0].critical_length = 3;
  Workspace<dim> workspace(problem.model, problem.state);
  problem.model.mpm.courant.reset();
  const TimeSteps without = stable_time_steps(problem.model, problem.state, workspace);
  EXPECT_EQ(without.by_default, without.stable);
  for (const Real courant : {0.4, 0.1}) {
    problem.model.mpm.courant = courant;
    const TimeSteps with = stable_time_steps(problem.model, problem.state, workspace);
    EXPECT_EQ(with.by_default, without.stable) << courant;
    EXPECT_LT(with.stable, without.stable) << courant;
  }
}

TYPED_TEST(TimeStep, a_velocity_that_is_not_finite_ends_the_run_with_time_step_and_advice)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  problem.state.time = 0.5;
  problem.state.step = 33;
  Workspace<dim> workspace(problem.model, problem.state);
  workspace.grids[0].mapped_velocity[workspace.grids[0].nodes[3]][0] = std::numeric_limits<Real>::quiet_NaN();
  try {
    stable_time_steps(problem.model, problem.state, workspace);
    FAIL() << "nothing was thrown";
  } catch (const RunError& error) {
    const std::string message = error.what();
    for (const char* part : {"not finite", "t = 0.5 s", "step 33", "mpm.courant"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TYPED_TEST(TimeStep, of_less_than_a_thousandth_of_that_at_rest_ends_the_run_with_what_moves_so_fast)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  Workspace<dim> workspace(problem.model, problem.state);
  problem.state.time = 0.5;
  problem.state.step = 32;
  const Real wave = std::sqrt(p_wave_modulus(sample_solid()) / 1500);
  const Index node = workspace.grids[0].nodes[3];
  workspace.grids[0].mapped_velocity[node] = 990 * wave * Vec<dim>::UnitX();
  EXPECT_NO_THROW(stable_time_steps(problem.model, problem.state, workspace));
  const auto expect_refused = [&](const std::string& what) {
    try {
      stable_time_steps(problem.model, problem.state, workspace);
      FAIL() << "nothing was thrown";
    } catch (const RunError& error) {
      const std::string message = error.what();
      for (const std::string& part : {std::string("the time step has fallen to "), std::string("t = 0.5 s"), std::string("step 32"), what})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    }
  };
  workspace.grids[0].mapped_velocity[node] = 1010 * wave * Vec<dim>::UnitX();
  expect_refused(fmt::format("body \"body\" at the node at ({:.6g}, ", problem.model.mesh.position[node][0]));
  problem.model.rigid_bodies.push_back({"pipe", make_shape<dim>(bodies::CircleSettings{std::vector<Real>(dim, 0), 0.5})});
  problem.state.rigid_bodies.emplace_back();
  problem.state.rigid_bodies[0].velocity = 2000 * wave * Vec<dim>::UnitX();
  expect_refused("rigid body \"pipe\"");
}

}  // namespace
}  // namespace berm::mpm::this_file
