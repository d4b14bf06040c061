// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/transfer.hpp"

#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm {
namespace {

/// A body of half the mesh whose particles have masses, velocities, volumes and stresses at random.
template <int dim>
struct Random {
  problem::Problem<dim> problem;
  Work<dim> work;

  Random() : problem(make()), work(problem.model, problem.state)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> number(-1, 1);
    for_each_particle(particles(), [&](bodies::Block<dim>& p, int l) {
      for (int d = 0; d < dim; ++d) p.v[d][l] = number(random);
      for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = number(random);
      p.mass[l] *= 2 + number(random);
      p.volume[l] *= 2 + number(random);
    });
    state().dt = 0.01;
  }
  static problem::Problem<dim> make()
  {
    mesh::Mesh<dim> mesh = shaken_box<dim>();
    auto problem = problem_on<dim>(mesh, sample_solid(), 0);
    // Cells of the upper half become empty, and with them some nodes.
    bodies::Particles<dim>& all = problem.state.particles[0];
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      while (mesh.centroid(cell)[1] > 0.8 && all.count_in(cell) > 0) all.take(cell, 0);
    all.sort_occupied();
    return problem;
  }

  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  const mesh::Mesh<dim>& mesh() const { return problem.model.mesh; }
  BodyGrid<dim>& grid() { return work.grids[0]; }
  problem::State<dim>& state() { return problem.state; }

  void to_the_nodes(bool project)
  {
    problem.model.mpm.volumetric_projection = project;
    sum_moments(mesh(), particles(), grid());
    gather_mass_and_momentum(mesh(), grid());
    spread_internal_forces(problem.model, particles(), grid());
  }
  Vec<dim> force(Index node) const
  {
    Vec<dim> f = Vec<dim>::Zero();
    for (Index e = mesh().first_entry[node]; e < mesh().first_entry[node + 1]; ++e)
      f += Eigen::Map<const Vec<dim>>(work.grids[0].at(mesh().entries[e]).sum);
    return f;
  }

  /// Calls add(node, N_i(x), grad N_i, block, lane) for each particle and each corner of its cell: sums as the paper writes them.
  template <class Add>
  void particle_by_particle(const Add& add)
  {
    particles().visit([&](Index cell, Index b, int l) {
      const bodies::Block<dim>& p = particles().block(b);
      const mesh::Shape<dim> shape = mesh().shape(cell);
      for (int k = 0; k <= dim; ++k) add(mesh().nodes[cell][k], shape.value(k, position(p, l)), shape.gradient(k), p, l);
    });
  }
};

template <class Dimension>
class Transfer : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Transfer, Dimensions);

TYPED_TEST(Transfer, nodes_get_the_mass_and_velocity_that_sums_over_particles_give)
{
  constexpr int dim = TypeParam::value;
  Random<dim> random;
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

TYPED_TEST(Transfer, internal_forces_are_minus_the_sum_of_volume_stress_and_gradient)
{
  constexpr int dim = TypeParam::value;
  Random<dim> random;
  random.to_the_nodes(false);
  NodeField<Vec<dim>> force(random.mesh().node_count(), Vec<dim>::Zero());
  Real size = 0;
  random.particle_by_particle([&](Index i, Real, const Vec<dim>& gradient, const bodies::Block<dim>& p, int l) {
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) force[i][a] -= p.volume[l] * p.stress[tensor_index(a, b)][l] * gradient[b];
    size = std::max(size, force[i].norm());
  });
  for (Index i : random.grid().nodes) EXPECT_NEAR((random.force(i) - force[i]).norm(), 0, 1e-12 * size);
}

TYPED_TEST(Transfer, new_velocities_are_those_of_particles_that_took_the_nodes_accelerations)
{
  constexpr int dim = TypeParam::value;
  Random<dim> random;
  random.to_the_nodes(false);
  std::mt19937 numbers(3);
  for (Index i : random.grid().nodes)
    random.grid().acceleration[i] = random_point<dim>(numbers, Vec<dim>::Constant(-9), Vec<dim>::Constant(9));
  spread_new_momentum(random.mesh(), random.particles(), random.state().dt, random.grid());
  gather_new_velocities(random.problem.model, random.grid());

  NodeField<Vec<dim>> momentum(random.mesh().node_count(), Vec<dim>::Zero());
  random.particles().visit([&](Index cell, Index b, int l) {
    const bodies::Block<dim>& p = random.particles().block(b);
    const auto& nodes = random.mesh().nodes[cell];
    const Vec<dim> x = position(p, l);
    Vec<dim> v = velocity(p, l);
    for (int k = 0; k <= dim; ++k) v += random.state().dt * random.mesh().shape(cell).value(k, x) * random.grid().acceleration[nodes[k]];
    for (int k = 0; k <= dim; ++k) momentum[nodes[k]] += p.mass[l] * random.mesh().shape(cell).value(k, x) * v;
  });
  for (Index i : random.grid().nodes)
    EXPECT_NEAR((random.grid().mapped_velocity[i] - momentum[i] / random.grid().mass[i]).norm(), 0, 1e-12);
}

TYPED_TEST(Transfer, held_directions_have_no_new_velocity)
{
  constexpr int dim = TypeParam::value;
  Random<dim> random;
  for (Index i = 0; i < random.mesh().node_count(); ++i) random.problem.model.fixed[0][i] = static_cast<std::uint8_t>(i % (1 << dim));
  random.to_the_nodes(true);
  spread_new_momentum(random.mesh(), random.particles(), random.state().dt, random.grid());
  gather_new_velocities(random.problem.model, random.grid());
  for (Index i : random.grid().nodes)
    for (int d = 0; d < dim; ++d) EXPECT_EQ(random.grid().mapped_velocity[i][d] == 0, (i % (1 << dim) >> d & 1) != 0);
}

TYPED_TEST(Transfer, mass_and_momentum_of_the_nodes_are_those_of_the_particles)
{
  constexpr int dim = TypeParam::value;
  Random<dim> random;
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

TYPED_TEST(Transfer, a_node_has_no_mass_where_round_off_is_all_of_it)
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
    Work<dim> work(problem.model, problem.state);
    sum_moments(mesh, particles, work.grids[0]);
    gather_mass_and_momentum(mesh, work.grids[0]);
    EXPECT_EQ(work.grids[0].mass[nodes[0]] > 0, of_cell > 1e-9) << of_cell;
    EXPECT_GT(work.grids[0].mass[nodes[1]], 0);
  }
}

TYPED_TEST(Transfer, a_node_of_light_particles_beside_a_heavy_body_has_their_mass)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  bodies::Particles<dim>& particles = problem.state.particles[0];
  const Index node = mesh.nodes[0][0];
  particles.visit([&](Index cell, Index b, int l) {
    if (std::count(mesh.nodes[cell].begin(), mesh.nodes[cell].end(), node) > 0) particles.block(b).mass[l] *= 1e-12;
  });
  Work<dim> work(problem.model, problem.state);
  sum_moments(mesh, particles, work.grids[0]);
  gather_mass_and_momentum(mesh, work.grids[0]);
  EXPECT_GT(work.grids[0].mass[node], 0);
}

template <int dim>
void expect_no_force_of_a_uniform_stress(const mesh::Mesh<dim>& mesh)
{
  for (const bool project : {false, true})
    for (const int n : {1, 2, 3}) {
      auto problem = problem_on<dim>(mesh, sample_solid(), dim == 2 ? n * n : n * n * n);
      problem.model.mpm.volumetric_projection = project;
      Work<dim> work(problem.model, problem.state);
      bodies::Particles<dim>& particles = problem.state.particles[0];
      const Real stress[6] = {-300, -500, -200, 120, 70, -90};
      for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
        for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = stress[k];
      });
      sum_moments(mesh, particles, work.grids[0]);
      gather_mass_and_momentum(mesh, work.grids[0]);
      spread_internal_forces(problem.model, particles, work.grids[0]);
      const auto at_boundary = boundary_flags(mesh);
      Real inner = 0, outer = 0;
      for (Index i = 0; i < mesh.node_count(); ++i) {
        Vec<dim> force = Vec<dim>::Zero();
        for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
          force += Eigen::Map<const Vec<dim>>(work.grids[0].at(mesh.entries[e]).sum);
        (at_boundary[i] ? outer : inner) = std::max(at_boundary[i] ? outer : inner, force.norm());
      }
      EXPECT_LT(inner, 1e-13 * outer) << "projection " << project << ", n " << n;
      EXPECT_GT(outer, 1);
    }
}

TEST(UniformStress, makes_no_force_inside_an_irregular_mesh_of_triangles)
{
  expect_no_force_of_a_uniform_stress(shaken_box<2>());
}
TEST(UniformStress, makes_no_force_inside_a_criss_cross_mesh)
{
  expect_no_force_of_a_uniform_stress(criss_cross<2>());
}
TEST(UniformStress, makes_no_force_inside_an_irregular_mesh_of_tetrahedra)
{
  expect_no_force_of_a_uniform_stress(shaken_box<3>());
}

}  // namespace
}  // namespace berm::mpm
