// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/internal_forces.hpp"

#include "mpm/moments.hpp"
#include "random_body.hpp"

namespace berm::mpm::this_file {
namespace {

template <class Dimension>
using InternalForces = OfRandomBody<Dimension>;
TYPED_TEST_SUITE(InternalForces, Dimensions);

TYPED_TEST(InternalForces, internal_forces_are_minus_the_sum_of_volume_stress_and_gradient)
{
  constexpr int dim = TypeParam::value;
  RandomBody<dim> random;
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

template <int dim>
void expect_no_force_of_a_uniform_stress(const mesh::Mesh<dim>& mesh)
{
  for (const bool project : {false, true})
    for (const int n : {1, 2, 3}) {
      auto problem = problem_on<dim>(mesh, sample_solid(), dim == 2 ? n * n : n * n * n);
      problem.model.mpm.volumetric_projection = project;
      Workspace<dim> workspace(problem.model, problem.state);
      bodies::Particles<dim>& particles = problem.state.particles[0];
      const Real stress[6] = {-300, -500, -200, 120, 70, -90};
      for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
        for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = stress[k];
      });
      sum_moments(mesh, particles, workspace.grids[0]);
      gather_mass_and_momentum(mesh, workspace.grids[0]);
      spread_internal_forces(problem.model, particles, 0, workspace.grids[0]);
      const auto at_boundary = boundary_flags(mesh);
      Real inner = 0, outer = 0;
      for (Index i = 0; i < mesh.node_count(); ++i) {
        Vec<dim> force = Vec<dim>::Zero();
        for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
          force += Eigen::Map<const Vec<dim>>(workspace.grids[0].at(mesh.entries[e]).sum);
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
}  // namespace berm::mpm::this_file
