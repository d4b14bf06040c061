// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// Moves all nodes by velocity(x) for one step, projection off.
template <int dim, class Velocity>
void move_once(problem::Problem<dim>& problem, Real dt, const Velocity& velocity_at)
{
  problem.model.mpm.volumetric_projection = false;
  problem.state.dt = dt;
  Workspace<dim> workspace(problem.model, problem.state);
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  sum_moments(mesh, problem.state.particles[0], workspace.grids[0]);
  gather_mass_and_momentum(mesh, workspace.grids[0]);
  for (Index i = 0; i < mesh.node_count(); ++i) workspace.grids[0].mapped_velocity[i] = velocity_at(mesh.position[i]);
  move_and_strain(problem.model, problem.state, workspace, 0);
}

TEST(Dilation, ends_where_a_particle_has_its_largest_volume)
{
  material::MohrCoulomb sand;
  sand.density = 1600;
  sand.young_modulus = 1e7;
  sand.poisson_ratio = 0.25;
  sand.friction_angle = 35 * pi / 180;
  sand.dilation_angle = 20 * pi / 180;
  // Simple shear of sand under 10 kPa at constant volume. Sand that dilates, but is not let, presses harder; sand that does not, does not.
  const auto pressure_after_shear = [&](Real volume_ratio) {
    auto problem = problem_on<2>(criss_cross<2>(), sand, 9);
    for_each_particle(problem.state.particles[0], [&](bodies::Block<2>& p, int l) {
      for (int k = 0; k < 3; ++k) p.stress[k][l] = -1e4;
      p.volume[l] = volume_ratio * p.mass[l] / sand.density;
    });
    move_once(problem, 1e-3, [](const Vec<2>& x) { return Vec<2>(20 * x[1], 0); });
    const auto stress = problem.state.particles[0].read_at(problem.state.particles[0].occupied()[0], 0).stress;
    return -trace(stress) / 3;
  };
  EXPECT_GT(pressure_after_shear(1), 2e4);
  // With a dilation angle of zero the in-plane mean stress stays; the stress out of the plane hardly moves.
  EXPECT_NEAR(pressure_after_shear(settings::MpmSettings{}.max_volume_ratio), 1e4, 1e3);
}

}  // namespace
}  // namespace berm::mpm::this_file
