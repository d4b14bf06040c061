// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/condition.hpp"

#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// A box of sand under 10 kPa, and a circle so large that half its width reaches all of it.
problem::Problem<2> pressed_box(const material::MohrCoulomb& soil)
{
  auto problem = problem_on<2>(shaken_box<2>(), soil, 9);
  bodies::RigidBody<2> pipe;
  pipe.shape = bodies::Circle<2>{.center = problem.model.mesh.upper + Vec<2>(0, 10), .radius = 10};
  problem.model.rigid_bodies.push_back(pipe);
  problem.state.rigid_bodies.resize(1);
  problem.model.main_rigid = 0;
  for_each_particle(problem.state.particles[0], [](bodies::Block<2>& p, int l) {
    for (int k = 0; k < 3; ++k) p.stress[k][l] = -1e4;
  });
  return problem;
}

/// What shaking() says where particles have these velocities and nodes those of node_velocity(x).
template <class Velocity, class NodeVelocity>
Real shaking_of(const Velocity& velocity_at, const NodeVelocity& node_velocity, const material::MohrCoulomb& soil = sample_sand())
{
  problem::Problem<2> problem = pressed_box(soil);
  for_each_particle(problem.state.particles[0], [&](bodies::Block<2>& p, int l) { set_velocity<2>(p, l, velocity_at(position<2>(p, l))); });
  Workspace<2> workspace(problem.model, problem.state);
  for (Index i = 0; i < problem.model.mesh.node_count(); ++i)
    workspace.grids[0].mapped_velocity[i] = node_velocity(problem.model.mesh.position[i]);
  return shaking(problem.model, problem.state, workspace);
}

TEST(Shaking, is_the_pressure_of_random_velocities_over_the_mean_pressure)
{
  std::mt19937 random(3);
  std::normal_distribution<Real> number(0, 0.1);
  const auto noise = [&](const Vec<2>&) { return Vec<2>(number(random), number(random)); };
  const Real wave_speed = std::sqrt(p_wave_modulus(material::Material(sample_sand())) / 1500);
  // The mean of nine velocities takes a ninth of their variance out.
  const Real expected = 1500 * wave_speed * 0.1 * std::sqrt(8. / 9) / 1e4;
  EXPECT_NEAR(shaking_of(noise, [](const Vec<2>&) { return Vec<2>(0, 0); }) / expected, 1, 0.05);  // some 500 random numbers: 3 %
}

TEST(Shaking, is_none_where_particles_move_as_the_nodes_do)
{
  const auto shear = [](const Vec<2>& x) { return Vec<2>(3 + 2 * x[1], 1 - x[0]); };
  EXPECT_LT(shaking_of(shear, shear), 1e-12);
}

TEST(Shaking, of_cohesive_soil_is_over_the_pressure_that_its_cohesion_stands_for_too)
{
  std::mt19937 random(3);
  std::normal_distribution<Real> number(0, 0.1);
  const auto noise = [&](const Vec<2>&) { return Vec<2>(number(random), number(random)); };
  const auto still = [](const Vec<2>&) { return Vec<2>(0, 0); };
  const Real without = shaking_of(noise, still);
  random.seed(3), number.reset();
  material::MohrCoulomb silt = sample_sand();
  silt.cohesion = 3e4 * std::tan(silt.friction_angle);  // c cot(phi) = 3 p: as strong as sand under four times the pressure
  EXPECT_NEAR(shaking_of(noise, still, silt), without / 4, 1e-9 * without);
}

TEST(Shaking, is_not_asked_of_soil_whose_strength_does_not_depend_on_pressure)
{
  material::MohrCoulomb clay = sample_sand();
  clay.friction_angle = clay.dilation_angle = 0;
  clay.cohesion = 1e4;
  const auto still = [](const Vec<2>&) { return Vec<2>(0, 0); };
  EXPECT_TRUE(std::isnan(shaking_of(still, still, clay)));
  EXPECT_FALSE(std::isnan(shaking_of(still, still)));
}

TEST(SoilCondition, counts_grains_in_the_air_and_at_the_bounds_of_volume)
{
  auto problem = problem_on<2>(shaken_box<2>(), sample_sand(), 9);
  bodies::Particles<2>& particles = problem.state.particles[0];
  const mesh::Mesh<2>& mesh = problem.model.mesh;
  const Real level = 0.4 * mesh.lower[1] + 0.6 * mesh.upper[1];
  // Sand up to a level, and one grain in the topmost cell.
  Index top = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (mesh.centroid(cell)[1] > mesh.centroid(top)[1]) top = cell;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (Index place = particles.count_in(cell); place-- > (cell == top ? 1 : 0);)
      if (cell == top || particles.read_at(cell, place).x[1] > level) particles.take(cell, place);
  particles.sort_occupied();
  const bodies::Particle<2> grain = particles.read_at(top, 0);
  Real mass = 0, smallest = 0, largest = 0;
  for_each_particle(particles, [&](bodies::Block<2>& p, int l) {
    mass += p.mass[l];
    const Real ratio = p.id[l] % 10 == 0 ? 0.8 : p.id[l] % 10 == 1 ? 1.2 : 1;
    p.volume[l] = ratio * p.mass[l] / 1500;
    if (ratio < 1) smallest += p.mass[l];
    if (ratio > 1) largest += p.mass[l];
  });
  const SoilCondition found = soil_condition(problem.model, problem.state);
  EXPECT_NEAR(found.in_the_air, grain.mass / mass, 1e-12);
  EXPECT_NEAR(found.at_min_volume, smallest / mass, 1e-12);
  EXPECT_NEAR(found.at_max_volume, largest / mass, 1e-12);
  EXPECT_GT(smallest, 0);
  EXPECT_GT(largest, 0);
}

}  // namespace
}  // namespace berm::mpm::this_file
