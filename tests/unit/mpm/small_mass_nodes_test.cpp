// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/small_mass_nodes.hpp"

#include "mpm/balance.hpp"
#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "mpm/velocities.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>
#include <tuple>

namespace berm::mpm::this_file {
namespace {

constexpr Real initial_stress = 1;  // Pa

/// Soil that bears all that happens here, in all cells or as one particle alone in the first, where its corners have these parts of its mass.
template <int dim>
struct Soil {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;

  explicit Soil(problem::Problem<dim> made) : problem(std::move(made)), workspace(problem.model, problem.state) {}

  static Soil full() { return Soil(soil_on(dim == 2 ? 9 : 8)); }
  static Soil alone(const std::array<Real, dim + 1>& shape)
  {
    auto made = soil_on(1);
    const mesh::Mesh<dim>& mesh = made.model.mesh;
    bodies::Particles<dim>& particles = made.state.particles[0];
    for (Index cell = 1; cell < mesh.cell_count(); ++cell)
      while (particles.count_in(cell) > 0) particles.take(cell, 0);
    particles.sort_occupied();
    Vec<dim> x = Vec<dim>::Zero();
    for (int k = 0; k <= dim; ++k) x += shape[k] * mesh.position[mesh.nodes[0][k]];
    for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
      for (int d = 0; d < dim; ++d) p.x[d][l] = x[d];
      for (int d = 0; d < 3; ++d) p.stress[d][l] = initial_stress;
    });
    return Soil(std::move(made));
  }

  const mesh::Mesh<dim>& mesh() const { return problem.model.mesh; }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }

  void prepare(Real dt)
  {
    problem.state.dt = dt;
    gather_mass_and_momentum(mesh(), grid());
    prepare_cells(problem.model, particles(), dt, grid());
  }
  void accelerate(Real dt)
  {
    prepare(dt);
    spread_internal_forces(problem.model, particles(), dt, grid());
    solve_momentum_balance(problem.model, problem.state, workspace, 0);
  }
  /// The stress of the particle after a step in which it stays where it is, Pa.
  SymTensor<dim> stress_after(Real dt)
  {
    accelerate(dt);
    // As at nodes that touch a rigid body: the velocity of step 4, without another mapping.
    for (const Index i : grid().nodes) grid().mapped_velocity[i] = dt * grid().acceleration[i];
    strain_particles(problem.model, problem.state, workspace, 0);
    SymTensor<dim> stress;
    for_each_particle(particles(), [&](bodies::Block<dim>& p, int l) {
      for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = p.stress[k][l];
    });
    return stress;
  }

private:
  static problem::Problem<dim> soil_on(int particles_per_cell)
  {
    material::MohrCoulomb strong = sample_sand();
    strong.friction_angle = 0;
    strong.cohesion = 1e9;
    strong.poisson_ratio = 0.4999;  // volume changes alone have stiffness
    auto made = problem_on<dim>(shaken_box<dim>(), strong, particles_per_cell);
    made.model.mpm.quadrature = settings::Quadrature::full_cells;
    made.model.mpm.volumetric_projection = false;
    made.model.mpm.bulk_viscosity = 0;
    return made;
  }
};

/// sum |grad N_k|^2 M / m_k of a particle that is alone, 1/m2.
template <int dim>
Real steepness(const Soil<dim>& soil, const std::array<Real, dim + 1>& shape)
{
  Real sum = 0;
  for (int k = 0; k <= dim; ++k) sum += soil.mesh().shape(0).gradient(k).squaredNorm() / shape[k];
  return sum;
}

template <int dim>
std::array<Real, dim + 1> near_a_face(Real part)
{
  std::array<Real, dim + 1> shape;
  shape.fill((1 - part) / dim);
  shape[dim] = part;
  return shape;
}

}  // namespace

template <class Dimension>
class SmallMassNodes : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SmallMassNodes, Dimensions);

TYPED_TEST(SmallMassNodes, cells_within_a_body_bear_any_stiffness_also_those_that_were_at_a_surface)
{
  constexpr int dim = TypeParam::value;
  auto soil = Soil<dim>::full();
  soil.grid().stiffness_limit[0] = 1;
  soil.prepare(1);
  for (const Index cell : soil.particles().occupied()) EXPECT_EQ(soil.grid().stiffness_limit[cell], 0) << cell;
}

TYPED_TEST(SmallMassNodes, of_cells_that_a_rigid_body_cuts_have_a_limit_however_full_they_are)
{
  constexpr int dim = TypeParam::value;
  auto soil = Soil<dim>::full();
  soil.grid().cut.parts = CellField<mesh::CellPart<dim>>::zeros(soil.mesh().cell_count());
  soil.grid().cut.parts[0].cut = true;
  soil.grid().cut.parts[0].volume = soil.mesh().volume(0);
  soil.prepare(1);
  for (const Index cell : soil.particles().occupied()) EXPECT_EQ(soil.grid().stiffness_limit[cell] > 0, cell == 0) << cell;
}

TYPED_TEST(SmallMassNodes, a_particle_alone_bears_the_stiffness_that_its_corners_can_follow_in_a_step)
{
  constexpr int dim = TypeParam::value;
  constexpr Real dt = 1e-3;
  for (const Real part : {0.25, 0.02, 1e-4}) {
    const auto shape = near_a_face<dim>(part);
    auto soil = Soil<dim>::alone(shape);
    soil.prepare(dt);
    EXPECT_NEAR(soil.grid().stiffness_limit[0] / (2 / (dt * dt * steepness(soil, shape))), 1, 1e-9) << part;
  }
}

TYPED_TEST(SmallMassNodes, stress_follows_each_part_of_the_strain_as_far_as_its_stiffness_is_borne)
{
  constexpr int dim = TypeParam::value;
  settings::SoilWaves soil;
  soil.bulk = 8;
  soil.shear = 2;
  SymTensor<dim> strain{};
  for (int k = 0; k < tensor_size<dim>; ++k) strain[k] = k + 1;  // mean 2
  for (const auto& [limit, volumetric, deviatoric] :
       {std::tuple(0., 1., 1.), std::tuple(8., 1., 1.), std::tuple(4., 0.5, 1.), std::tuple(1., 0.125, 0.5)}) {
    const SymTensor<dim> limited = limited_strain(strain, soil, limit);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(limited[k], volumetric * 2 + deviatoric * (strain[k] - 2), 1e-15) << limit << " " << k;
    for (int k = 3; k < tensor_size<dim>; ++k) EXPECT_NEAR(limited[k], deviatoric * strain[k], 1e-15) << limit << " " << k;
  }
}

TYPED_TEST(SmallMassNodes, the_stress_of_a_particle_alone_does_not_grow)
{
  constexpr int dim = TypeParam::value;
  for (const bool bounded : {true, false}) {
    const auto shape = near_a_face<dim>(0.02);
    auto soil = Soil<dim>::alone(shape);
    if (!bounded) soil.grid().stiffness_limit = {};
    const Real dt = 2 / std::sqrt(soil.problem.model.bodies[0].waves.bulk * steepness(soil, shape));  // so that (omega dt)^2 = 4
    Real largest = 0;
    for (int n = 0; n < 20; ++n) {
      const SymTensor<dim> stress = soil.stress_after(dt);
      largest = std::max(largest, std::abs(trace(stress)) / 3);
    }
    if (bounded)
      EXPECT_LT(largest, 1.05 * initial_stress);
    else
      EXPECT_GT(largest, 1000 * initial_stress);
  }
}

TYPED_TEST(SmallMassNodes, a_node_of_small_mass_is_not_damped)
{
  constexpr int dim = TypeParam::value;
  constexpr Real damping = 0.5;
  for (const Real part : {0.004, 0.9}) {
    const auto shape = near_a_face<dim>(part);
    auto soil = Soil<dim>::alone(shape);
    for_each_particle(soil.particles(), [](bodies::Block<dim>& p, int l) { set_velocity<dim>(p, l, Vec<dim>::Ones()); });
    sum_moments(soil.mesh(), soil.particles(), soil.grid());
    std::fill(soil.problem.model.bodies[0].damping.begin(), soil.problem.model.bodies[0].damping.end(), damping);
    soil.accelerate(1e-6);
    const Index node = soil.mesh().nodes[0][dim];
    Vec<dim> force = Vec<dim>::Zero();
    for (Index e = soil.mesh().first_entry[node]; e < soil.mesh().first_entry[node + 1]; ++e)
      force += Eigen::Map<const Vec<dim>>(soil.grid().at(soil.mesh().entries[e]).sum);
    const Real full = soil.problem.model.bodies[0].waves.min_density * soil.grid().volume_around[node] / (dim + 1);
    const bool small = soil.grid().mass[node] < 0.05 * full;
    ASSERT_EQ(small, part < 0.5);
    for (int d = 0; d < dim; ++d) {
      const Real damped = force[d] - (small ? 0 : damping * std::abs(force[d]));
      EXPECT_NEAR(soil.grid().acceleration[node][d] * soil.grid().mass[node], damped, 1e-9 * force.norm()) << part << " " << d;
    }
  }
}

// One cell, whose nodes are at the radii 0, 2 and 0: R = 2 m.
TEST(LightCornersAroundAnAxis, count_the_hoop_strain_of_nodes_away_from_it)
{
  mesh::Mesh<2> mesh = shaken_box<2>();
  mesh.metric = mesh::Metric::axisymmetric;
  const auto [a, b, c] = mesh.nodes[0];
  mesh.position[a] = {0, 0};
  mesh.position[b] = {2, 0};
  mesh.position[c] = {0, 1};
  BodyGrid<2> grid(mesh);
  grid.enter(mesh, 0);
  for (auto& corner : grid.corners[0]) corner.mass = 1;
  grid.mass[a] = 2;
  grid.mass[b] = 4;
  grid.mass[c] = 5;
  // grad N = (-1/2, -1), (1/2, 0), (0, 1) 1/m; the nodes at the axis move along it alone.
  const Real sum = 1. / 2 + (0.5 + 0.5) * (0.5 + 0.5) / 4 + 1. / 5;
  EXPECT_NEAR(max_stable_stiffness(mesh, grid, 0, 0.1), 2 / (0.01 * 3 * sum), 1e-10);
}

}  // namespace berm::mpm::this_file
