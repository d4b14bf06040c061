// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "sample_problem.hpp"
#include "samples/critical_state_soils.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

template <class T>
class IntergranularStrain : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(IntergranularStrain, Dimensions);

// A rotation by a small angle about z gives a tensor with xx = 3, yy = 1 an xy of (3 - 1) angle, but for angle^2.
TYPED_TEST(IntergranularStrain, turns_with_the_soil)
{
  constexpr int dim = TypeParam::value;
  constexpr Real angle = 1e-4, dt = 1e-3, xx = 3e-5, yy = 1e-5;
  auto problem = problem_on<dim>(make_box<dim>(sample_box<dim>()), sample_hypoplastic(), 1);
  problem.model.mpm.volumetric_projection = false;
  problem.state.dt = dt;
  bodies::Particles<dim>& particles = problem.state.particles[0];
  particles.visit([&](Index, Index b, int l) {
    for (int k = 0; k < 3; ++k) particles.block(b).stress[k][l] = k == 0 ? -1.2e4 : -1e4;
    const Real state[7] = {0.8, xx, yy, 0, 0, 0, 0};
    for (int k = 0; k < 7; ++k) particles.state(b)[k][l] = state[k];
  });
  Workspace<dim> workspace(problem.model, problem.state);
  BodyGrid<dim>& grid = workspace.grids[0];
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  sum_moments(mesh, particles, grid);
  gather_mass_and_momentum(mesh, grid);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    grid.mapped_velocity[i].setZero();
    grid.mapped_velocity[i].template head<2>() = angle / dt * Vec<2>(-mesh.position[i][1], mesh.position[i][0]);
  }
  move_and_strain(problem.model, problem.state, workspace, 0);
  particles.visit([&](Index, Index b, int l) {
    EXPECT_NEAR(particles.state(b)[4][l], (xx - yy) * angle, 1e-3 * xx * angle);
    EXPECT_NEAR(particles.state(b)[1][l], xx, 1e-3 * xx);
    EXPECT_NEAR(particles.block(b).stress[3][l], -2e3 * angle, 1e-3 * 2e3 * angle) << "as the stress does";
  });
}

}  // namespace
}  // namespace berm::mpm::this_file
