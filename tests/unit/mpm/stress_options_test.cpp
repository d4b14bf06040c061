// SPDX-License-Identifier: BSD-3-Clause
// Averaging over full cells, and dilation that ends where a particle cannot grow any more.
#include "mpm/move.hpp"
#include "mpm/transfer.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm {
namespace {

/// Moves all nodes by velocity(x) for one step, projection off.
template <int dim, class Velocity>
void move_once(Problem<dim>& problem, Real dt, const Velocity& velocity_at)
{
  problem.model.mpm.volumetric_projection = false;
  problem.state.dt = dt;
  Work<dim> work(problem.model, problem.state);
  const Mesh<dim>& mesh = problem.model.mesh;
  sum_moments(mesh, problem.state.particles[0], work.grids[0]);
  gather_mass_and_momentum(mesh, work.grids[0]);
  for (Index i = 0; i < mesh.node_count(); ++i) work.grids[0].moved_velocity[i] = velocity_at(mesh.position[i]);
  move_and_strain(problem.model, problem.state, work, 0);
}

TEST(MixedStress, is_the_volume_average_in_full_cells_and_leaves_others_alone)
{
  auto problem = problem_on<2>(criss_cross<2>(), sample_solid(), 9);
  problem.model.mpm.mixed_stress = true;
  Particles<2>& particles = problem.state.particles[0];
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> number(-1e3, 1e3);
  const Index full = particles.occupied()[0], partial = particles.occupied()[1];
  for_each_particle(particles, [&](Block<2>& p, int l) {
    for (int k = 0; k < 4; ++k) p.stress[k][l] = number(random);
  });
  // Eight ninths are less than the nine tenths from which a cell counts as full.
  particles.take(partial, 0);
  const auto stresses = [&](Index cell) {
    std::vector<SymTensor<2>> all;
    for (Index place = 0; place < particles.count_in(cell); ++place) all.push_back(particles.read_at(cell, place).stress);
    return all;
  };
  const auto before_full = stresses(full), before_partial = stresses(partial);
  move_once(problem, 1e-6, [](const Vec<2>&) { return Vec<2>(0, 0); });
  for (int k = 0; k < 4; ++k) {
    Real mean = 0;
    for (const auto& stress : before_full) mean += stress[k] / static_cast<Real>(before_full.size());
    for (const auto& stress : stresses(full)) EXPECT_NEAR(stress[k], mean, 1e-9);  // round-off of 1e3
    const auto after_partial = stresses(partial);
    for (std::size_t p = 0; p < after_partial.size(); ++p) EXPECT_EQ(after_partial[p][k], before_partial[p][k]);
  }
}

TEST(Dilation, ends_where_a_particle_has_its_largest_volume)
{
  MohrCoulomb sand;
  sand.density = 1600;
  sand.young_modulus = 1e7;
  sand.poisson_ratio = 0.25;
  sand.friction_angle = 35 * pi / 180;
  sand.dilation_angle = 20 * pi / 180;
  // Simple shear of sand under 10 kPa at constant volume. Sand that dilates, but is not let, presses harder; sand that does not, does not.
  const auto pressure_after_shear = [&](Real volume_ratio) {
    auto problem = problem_on<2>(criss_cross<2>(), sand, 9);
    for_each_particle(problem.state.particles[0], [&](Block<2>& p, int l) {
      for (int k = 0; k < 3; ++k) p.stress[k][l] = -1e4;
      p.volume[l] = volume_ratio * p.mass[l] / sand.density;
    });
    move_once(problem, 1e-3, [](const Vec<2>& x) { return Vec<2>(20 * x[1], 0); });
    const auto stress = problem.state.particles[0].read_at(problem.state.particles[0].occupied()[0], 0).stress;
    return -trace(stress) / 3;
  };
  EXPECT_GT(pressure_after_shear(1), 2e4);
  // With a dilation angle of zero the in-plane mean stress stays; the stress out of the plane hardly moves.
  EXPECT_NEAR(pressure_after_shear(MpmSettings{}.most_volume_ratio), 1e4, 1e3);
}

}  // namespace
}  // namespace berm
