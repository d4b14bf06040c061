// SPDX-License-Identifier: BSD-3-Clause
// Free bodies: falling, spinning, at rest.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// An elastic block of 0.4 m a side somewhere in an empty box of 1 m a side with cells of 0.1 m.
template <int dim>
settings::Case free_block(std::vector<Real> center)
{
  center.resize(dim, 0.5);
  settings::Case c = elastic_box(dim, std::vector<Real>(dim, 1), std::vector<Real>(dim, 10), 1e6, 0.3, 1000);
  bodies::BlockSettings block;
  block.center = center;
  block.size.assign(dim, 0.4);
  block.spacing = 0.05;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  return c;
}

/// Speed and place after `steps` steps are those of the sums v = sum dt g, x = sum dt v, and no stress is made.
template <int dim>
void expect_free_fall(settings::Case c, int steps)
{
  bodies::InitialVelocity motion;
  motion.amplitude = {0.7, 0.9, -0.5};
  motion.amplitude.resize(dim);
  c.body[0].second.initial_velocity = {motion};
  c.gravity = {0, -10, 1};
  c.gravity.resize(dim);
  Simulation<dim> run(c);
  const auto before = all_particles(run.state());
  Vec<dim> v, moved_by = Vec<dim>::Zero();
  for (int d = 0; d < dim; ++d) v[d] = motion.amplitude[d];
  Real stress = 0, error = 0;
  for (int n = 0; n < steps; ++n) {
    take_steps(run, 1);
    v += run.state().dt * run.model().gravity;
    moved_by += run.state().dt * v;
  }
  const auto after = all_particles(run.state());
  for (std::size_t k = 0; k < after.size(); ++k) {
    error = std::max({error, (after[k].v - v).norm(), (after[k].x - before[k].x - moved_by).norm()});
    for (int d = 0; d < tensor_size<dim>; ++d) stress = std::max(stress, std::abs(after[k].stress[d]));
  }
  EXPECT_LT(error, 1e-12);  // of 1 m/s and 0.1 m
  EXPECT_LT(stress, 1e-9 * 1e6);
  EXPECT_GT(moved_by.norm(), 0.05);  // it crossed cells
  EXPECT_LT(mpm::momentum_error(run.state()), 1e-12);
}

TEST(FreeFall, is_exact_in_triangles)
{
  expect_free_fall<2>(free_block<2>({0.463, 0.511}), 80);
}
TEST(FreeFall, is_exact_in_tetrahedra)
{
  expect_free_fall<3>(free_block<3>({0.463, 0.511, 0.532}), 120);
}
// Particles that lie exactly on nodes and faces give the far nodes of their cells nothing but round-off.
TEST(FreeFall, is_exact_where_particles_begin_on_nodes_and_faces_of_triangles)
{
  expect_free_fall<2>(free_block<2>({0.475, 0.475}), 80);
}
TEST(FreeFall, is_exact_where_particles_begin_on_nodes_and_faces_of_tetrahedra)
{
  expect_free_fall<3>(free_block<3>({0.475, 0.475, 0.475}), 120);
}
TEST(FreeFall, is_exact_with_one_particle_on_a_node)
{
  settings::Case c = free_block<2>({0.5, 0.5});
  c.body[0].second.block->size = {0.05, 0.05};
  expect_free_fall<2>(c, 80);
}

TEST(Rest, a_bed_under_its_own_stress_stays_at_rest_without_projection)
{
  // The stress is linear in depth and so are the weights that corners get: forces balance to round-off at every node.
  settings::Case c = elastic_box(2, {0.6, 0.4}, {12, 8}, 7e6, 0.25, 877);
  c.gravity = {0, -490};
  c.surface = 0.4;
  c.body[0].second.k0 = 0.43;
  c.mpm.volumetric_projection = false;
  c.support = {{"base", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  Simulation<2> run(c);
  take_steps(run, 300);
  Real fastest = 0;
  for (const auto& p : all_particles(run.state())) fastest = std::max(fastest, p.v.norm());
  EXPECT_LT(fastest, 1e-10);  // g t is 10 m/s
  EXPECT_GT(run.state().time * 490, 10);
}

TEST(Rotation, a_free_square_keeps_its_angular_momentum_and_makes_little_stress)
{
  settings::Case c = free_block<2>({0.5, 0.5});
  std::get<mesh::BoxMesh>(c.mesh).cells = {20, 20};
  c.body[0].second.block->spacing = 0.0125;
  Simulation<2> run(c);
  // A quarter turn. The corners move with a hundredth of the speed of waves: the stress of the turn, density (omega r)^2, is a ten-thousandth of
  // the stiffness; what particles make that cross cells with linear shape functions is some thirty times that.
  constexpr Real omega = 1.2, radius = 0.283;
  run.set_velocities([&](const Vec<2>& x, const Vec<2>&) { return Vec<2>(-omega * (x[1] - 0.5), omega * (x[0] - 0.5)); });
  const bodies::Particles<2>& particles = run.state().particles[0];
  const auto turn_of_all = [&] {
    Real turn = 0;
    for (const auto& p : all_particles(run.state())) turn += p.mass * ((p.x[0] - 0.5) * p.v[1] - (p.x[1] - 0.5) * p.v[0]);
    return turn;
  };
  const Real kinetic = mpm::sums_over(particles).kinetic, turn = turn_of_all();
  run.run_until(pi / 2 / omega);
  Real stress = 0;
  for (const auto& p : all_particles(run.state()))
    for (int k = 0; k < 4; ++k) stress = std::max(stress, std::abs(p.stress[k]));
  EXPECT_LT(stress, 60 * 1000 * omega * omega * radius * radius);
  EXPECT_GT(turn_of_all() / turn, 0.95);
  EXPECT_GT(mpm::sums_over(particles).kinetic / kinetic, 0.92);
}

}  // namespace
}  // namespace berm::this_file
