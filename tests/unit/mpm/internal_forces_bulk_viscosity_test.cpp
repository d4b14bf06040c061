// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

material::MohrCoulomb sand(Real dilation_angle)
{
  material::MohrCoulomb law = sample_sand();
  law.dilation_angle = dilation_angle;
  return law;
}

/// Soil without stress whose particles move as `velocity_at(x)` says, with the internal forces of its cells.
template <int dim>
struct Moving {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;

  template <class Velocity>
  Moving(const material::Material& material, bool project, const Velocity& velocity_at)
      : problem(problem_on<dim>(shaken_box<dim>(), material, dim == 2 ? 9 : 8)),
        workspace(problem.model, problem.state)
  {
    problem.model.mpm.volumetric_projection = project;
    if (!project) problem.model.patches = make_patches(problem.model.mesh, 1);
    bodies::Particles<dim>& particles = problem.state.particles[0];
    for_each_particle(particles, [&](bodies::Block<dim>& p, int l) { set_velocity<dim>(p, l, velocity_at(position(p, l))); });
    sum_moments(problem.model.mesh, particles, workspace.grids[0]);
    gather_mass_and_momentum(problem.model.mesh, workspace.grids[0]);
    find_viscous_stress(problem.model, particles, workspace.grids[0]);
    spread_internal_forces(problem.model, particles, 0, workspace.grids[0]);
  }

  Real largest_force() const
  {
    Real largest = 0;
    for (const auto& corners : workspace.grids[0].corners)
      for (const auto& corner : corners) largest = std::max(largest, Eigen::Map<const Vec<dim>>(corner.sum).norm());
    return largest;
  }
  /// Of the forces on the nodes, W.
  Real power() const
  {
    Real sum = 0;
    const mesh::Mesh<dim>& mesh = problem.model.mesh;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (int k = 0; k <= dim; ++k)
        sum += Eigen::Map<const Vec<dim>>(workspace.grids[0].corners[cell][k].sum).dot(workspace.grids[0].velocity[mesh.nodes[cell][k]]);
    return sum;
  }
  Real divergence(Index cell) const
  {
    Real sum = 0;
    const mesh::Mesh<dim>& mesh = problem.model.mesh;
    for (int k = 0; k <= dim; ++k) sum += mesh.shape(cell).gradient(k).dot(workspace.grids[0].velocity[mesh.nodes[cell][k]]);
    return sum;
  }
};

template <int dim>
Vec<dim> swirl(const Vec<dim>& x)
{
  Vec<dim> v;
  for (int d = 0; d < dim; ++d) v[d] = std::sin(7 * x[d] + 3 * x[(d + 1) % dim]);
  return v;
}

template <class Dimension>
class BulkViscosity : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BulkViscosity, Dimensions);

TYPED_TEST(BulkViscosity, takes_out_the_power_of_viscous_stress_on_the_rate_of_volume_change)
{
  constexpr int dim = TypeParam::value;
  const Moving<dim> soil(sand(0.5), false, swirl<dim>);
  const mesh::Mesh<dim>& mesh = soil.problem.model.mesh;
  const Real viscosity = 0.06 * std::sqrt(p_wave_modulus(material::Material(sand(0.5))) * 1500);
  Real taken_out = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    taken_out += viscosity * mesh.volume(cell) * mesh.height(cell) * std::pow(soil.divergence(cell), 2);
  EXPECT_GT(taken_out, 0);
  EXPECT_NEAR(soil.power() / taken_out, -1, 1e-12);
}

TYPED_TEST(BulkViscosity, never_gives_power_with_the_projection)
{
  constexpr int dim = TypeParam::value;
  const Moving<dim> projected(sand(0.5), true, swirl<dim>), plain(sand(0.5), false, swirl<dim>);
  EXPECT_LT(projected.power(), 0);
  EXPECT_GT(projected.power(), plain.power());  // the mean over a patch leaves less to resist
}

TYPED_TEST(BulkViscosity, makes_no_force_in_uniform_motion)
{
  constexpr int dim = TypeParam::value;
  const Moving<dim> soil(sand(0.5), true, [](const Vec<dim>&) { return Vec<dim>(Vec<dim>::Constant(3)); });
  const Moving<dim> moving(sand(0.5), true, swirl<dim>);
  EXPECT_LT(soil.largest_force(), 1e-12 * moving.largest_force());
}

TYPED_TEST(BulkViscosity, is_the_same_in_soil_that_does_not_dilate)
{
  constexpr int dim = TypeParam::value;
  EXPECT_EQ((Moving<dim>(sand(0), true, swirl<dim>).power()), (Moving<dim>(sand(0.5), true, swirl<dim>).power()));
}

TYPED_TEST(BulkViscosity, is_not_in_elastic_bodies)
{
  constexpr int dim = TypeParam::value;
  EXPECT_EQ((Moving<dim>(sample_solid(), true, swirl<dim>).largest_force()), 0);
}

}  // namespace
}  // namespace berm::mpm::this_file
