// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"

#include "mpm/linear_field.hpp"
#include "random_body.hpp"

namespace berm::mpm::this_file {
namespace {

template <class Dimension>
using Moments = OfRandomBody<Dimension>;
TYPED_TEST_SUITE(Moments, Dimensions);

TYPED_TEST(Moments, nodes_get_the_mass_and_velocity_that_sums_over_particles_give)
{
  constexpr int dim = TypeParam::value;
  for (const Real place : places) {
    SCOPED_TRACE(place);
    RandomBody<dim> random(place);
    random.to_the_nodes(false);
    NodeField<Real> mass(random.mesh().node_count(), 0);
    NodeField<Vec<dim>> momentum(random.mesh().node_count(), Vec<dim>::Zero());
    random.particle_by_particle([&](Index i, Real n, const Vec<dim>&, const bodies::Block<dim>& p, int l) {
      mass[i] += p.mass[l] * n;
      momentum[i] += p.mass[l] * n * velocity(p, l);
    });
    Index massive = 0;
    for (Index i = 0; i < mass.size(); ++i) {
      massive += mass[i] > 0;
      if (!(mass[i] > 0)) continue;
      EXPECT_NEAR(random.grid().mass[i] / mass[i], 1, 1e-12);
      EXPECT_NEAR((random.grid().velocity[i] - momentum[i] / mass[i]).norm(), 0, 1e-12);
    }
    EXPECT_EQ(massive, static_cast<Index>(random.grid().nodes.size()));
    EXPECT_LT(massive, random.mesh().node_count());
  }
}

TYPED_TEST(Moments, mass_and_momentum_of_the_nodes_are_those_of_the_particles)
{
  constexpr int dim = TypeParam::value;
  RandomBody<dim> random;
  random.to_the_nodes(true);
  Real mass = 0, of_nodes = 0;
  Vec<dim> momentum = Vec<dim>::Zero(), momentum_of_nodes = Vec<dim>::Zero(), force = Vec<dim>::Zero();
  Real size = 0;
  for_each_particle(random.particles(), [&](bodies::Block<dim>& p, int l) { mass += p.mass[l], momentum += p.mass[l] * velocity(p, l); });
  for (Index i : random.grid().nodes) {
    of_nodes += random.grid().mass[i];
    momentum_of_nodes += random.grid().mass[i] * random.grid().velocity[i];
    force += random.force(i);
    size += random.force(i).norm();
  }
  EXPECT_NEAR(of_nodes / mass, 1, 1e-14);
  EXPECT_NEAR((momentum_of_nodes - momentum).norm() / mass, 0, 1e-14);
  EXPECT_NEAR(force.norm() / size, 0, 1e-14);  // internal forces give no momentum
}

TYPED_TEST(Moments, give_the_momentum_of_particles_that_move_with_the_nodes)
{
  constexpr int dim = TypeParam::value;
  for (const Real place : places) {
    SCOPED_TRACE(place);
    RandomBody<dim> random(place);
    random.to_the_nodes(false);
    const mesh::Mesh<dim>& mesh = random.mesh();
    NodeField<Vec<dim>> of_nodes(mesh.node_count(), Vec<dim>::Zero());
    for (Index i = 0; i < of_nodes.size(); ++i)
      for (int d = 0; d < dim; ++d) of_nodes[i][d] = std::cos(3 * i + d);
    std::vector<std::array<Vec<dim>, dim + 1>> wanted(mesh.cell_count());
    for (auto& of_cell : wanted) of_cell.fill(Vec<dim>::Zero());
    random.particles().visit([&](Index cell, Index b, int l) {
      const bodies::Block<dim>& p = random.particles().block(b);
      const mesh::Shape<dim> shape = mesh.shape(cell);
      Vec<dim> v = Vec<dim>::Zero();
      for (int k = 0; k <= dim; ++k) v += shape.value(k, position(p, l)) * of_nodes[mesh.nodes[cell][k]];
      for (int k = 0; k <= dim; ++k) wanted[cell][k] += p.mass[l] * shape.value(k, position(p, l)) * v;
    });
    for (const Index cell : random.particles().occupied()) {
      const AtCorners<dim> found = momentum_with(random.grid().moments[cell], at_corners(mesh.nodes[cell], of_nodes));
      const Real round_off = 1e-13 * random.grid().moments[cell].total_mass();
      for (int k = 0; k <= dim; ++k) EXPECT_NEAR((vector_of<dim>(found[k]) - wanted[cell][k]).norm(), 0, round_off);
    }
  }
}

TYPED_TEST(Moments, a_node_has_no_mass_where_round_off_is_all_of_it)
{
  constexpr int dim = TypeParam::value;
  for (const Real of_cell : {1e-13, 1e-6}) {  // what the node gets of the mass in the only cell with particles
    auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
    const mesh::Mesh<dim>& mesh = problem.model.mesh;
    bodies::Particles<dim>& particles = problem.state.particles[0];
    for (Index cell = 1; cell < mesh.cell_count(); ++cell)
      while (particles.count_in(cell) > 0) particles.take(cell, 0);
    particles.sort_occupied();
    const auto& nodes = mesh.nodes[0];
    const Vec<dim> apex = mesh.position[nodes[0]], beside = (mesh.position[nodes[1]] + mesh.position[nodes[2]]) / 2;
    for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
      for (int d = 0; d < dim; ++d) p.x[d][l] = beside[d] + of_cell * (apex[d] - beside[d]);
    });
    Workspace<dim> workspace(problem.model, problem.state);
    sum_moments(mesh, particles, workspace.grids[0]);
    gather_mass_and_momentum(mesh, workspace.grids[0]);
    EXPECT_EQ(workspace.grids[0].mass[nodes[0]] > 0, of_cell > 1e-9) << of_cell;
    EXPECT_GT(workspace.grids[0].mass[nodes[1]], 0);
  }
}

TYPED_TEST(Moments, a_node_of_light_particles_beside_a_heavy_body_has_their_mass)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  bodies::Particles<dim>& particles = problem.state.particles[0];
  const Index node = mesh.nodes[0][0];
  particles.visit([&](Index cell, Index b, int l) {
    if (std::count(mesh.nodes[cell].begin(), mesh.nodes[cell].end(), node) > 0) particles.block(b).mass[l] *= 1e-12;
  });
  Workspace<dim> workspace(problem.model, problem.state);
  sum_moments(mesh, particles, workspace.grids[0]);
  gather_mass_and_momentum(mesh, workspace.grids[0]);
  EXPECT_GT(workspace.grids[0].mass[node], 0);
}

}  // namespace
}  // namespace berm::mpm::this_file
