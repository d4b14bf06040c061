// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/body_sums.hpp"
#include "mpm/change_cells.hpp"
#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "mpm/velocities.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// Steps 1 to 9 of soil without stress and forces, so that only the filter changes velocities.
template <int dim>
struct Drifting {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;

  template <class Velocity>
  Drifting(const material::Material& material, const Velocity& velocity_at, Real filter = settings::MpmSettings{}.velocity_filter)
      : problem(filtered(problem_on<dim>(shaken_box<dim>(), material, dim == 2 ? 9 : 8), filter)),
        workspace(problem.model, problem.state)
  {
    problem.model.mpm.volumetric_projection = false;
    problem.state.dt = 1e-3;  // a particle moves by some thousandths of a cell
    for_each_particle(particles(), [&](bodies::Block<dim>& p, int l) { set_velocity<dim>(p, l, velocity_at(position<dim>(p, l))); });
  }
  static problem::Problem<dim> filtered(problem::Problem<dim> made, Real filter)
  {
    made.model.mpm.velocity_filter = filter;
    return made;
  }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }

  void step()
  {
    const mesh::Mesh<dim>& mesh = problem.model.mesh;
    sum_moments(mesh, particles(), grid());
    gather_mass_and_momentum(mesh, grid());
    prepare_cells(problem.model, particles(), problem.state.dt, grid());
    smooth_velocities(mesh, grid());
    spread_internal_forces(problem.model, particles(), problem.state.dt, grid());
    spread_new_momentum(mesh, particles(), problem.state.dt, grid());
    gather_new_velocities(problem.model, {}, grid());
    move_and_strain(problem.model, problem.state, workspace, 0);
    change_cells(problem.model, problem.state, workspace, 0);
  }
};

template <int dim>
auto noise()
{
  return [random = std::mt19937(7)](const Vec<dim>&) mutable {
    Vec<dim> v;
    for (int d = 0; d < dim; ++d) v[d] = std::uniform_real_distribution<Real>(-1, 1)(random);
    return v;
  };
}

template <class Dimension>
class VelocityFilter : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(VelocityFilter, Dimensions);

TYPED_TEST(VelocityFilter, takes_noise_out_and_books_its_energy_but_keeps_momentum)
{
  constexpr int dim = TypeParam::value;
  auto velocities = noise<dim>();
  Drifting<dim> soil(sample_sand(), [&](const Vec<dim>& x) { return velocities(x); });
  const auto before = sums_over(soil.particles());
  for (int n = 0; n < 20; ++n) soil.step();
  const auto after = sums_over(soil.particles());
  EXPECT_LT(after.kinetic, 0.9 * before.kinetic);
  EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-12 * before.mass);
  EXPECT_NEAR(soil.problem.state.ledger.totals.filter, before.kinetic - after.kinetic, 1e-10 * before.kinetic);
}

TYPED_TEST(VelocityFilter, keeps_the_momentum_of_each_patch_and_not_of_each_cell)
{
  constexpr int dim = TypeParam::value;
  auto velocities = noise<dim>();
  Drifting<dim> soil(
      sample_sand(), [&](const Vec<dim>& x) { return velocities(x); }, 1);
  const mesh::Mesh<dim>& mesh = soil.problem.model.mesh;
  sum_moments(mesh, soil.particles(), soil.grid());
  const auto before = soil.grid().moments;
  soil.problem.state.dt = 1e-9;  // no particle leaves its cell, whatever the part that the filter takes
  soil.grid().filter_speed = infinity;
  soil.step();
  Real change = 0, between_cells = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int d = 0; d < dim; ++d) {
      const auto gained = [&](Index of) { return soil.grid().moments[of].total_momentum()[d] - before[of].total_momentum()[d]; };
      const Real mass = before[cell].total_mass();
      Real by_patch = 0;
      mesh::for_each_in_patch(soil.problem.model.patches, cell, [&](Index member) { by_patch += gained(member); });
      EXPECT_NEAR(by_patch, 0, 1e-12 * mass);
      between_cells = std::max(between_cells, std::abs(gained(cell)) / mass);
      change = std::max(change, std::abs(soil.grid().moments[cell].momentum[1][d] - before[cell].momentum[1][d]) / mass);
    }
  EXPECT_GT(change, 1e-3);
  EXPECT_GT(between_cells, 1e-3) << "velocities of cells that cancel at the nodes would grow";
}

TYPED_TEST(VelocityFilter, leaves_uniform_motion_alone)
{
  constexpr int dim = TypeParam::value;
  Drifting<dim> soil(sample_sand(), [](const Vec<dim>&) { return Vec<dim>(Vec<dim>::Constant(0.05)); });
  for (int n = 0; n < 20; ++n) soil.step();
  for_each_particle(soil.particles(),
                    [](bodies::Block<dim>& p, int l) { EXPECT_NEAR((velocity<dim>(p, l) - Vec<dim>::Constant(0.05)).norm(), 0, 1e-12); });
}

TYPED_TEST(VelocityFilter, is_in_the_momentum_that_nodes_are_told)
{
  constexpr int dim = TypeParam::value;
  auto velocities = noise<dim>();
  Drifting<dim> soil(
      sample_sand(), [&](const Vec<dim>& x) { return velocities(x); }, 1);
  soil.step();
  const NodeField<Vec<dim>> before = soil.grid().velocity, told = soil.grid().mapped_velocity;
  soil.problem.state.dt = 0;
  soil.step();  // maps the particles as they are now: but for how far they moved, that is what was told
  Real error = 0, change = 0;
  for (Index i : soil.grid().nodes) {
    error = std::max(error, (soil.grid().velocity[i] - told[i]).norm());
    change = std::max(change, (before[i] - told[i]).norm());
  }
  EXPECT_LT(error, 0.3 * change);
}

TYPED_TEST(VelocityFilter, leaves_the_corners_the_volume_of_their_cell_though_its_shift_is_kept_there)
{
  constexpr int dim = TypeParam::value;
  auto velocities = noise<dim>();
  Drifting<dim> soil(sample_sand(), [&](const Vec<dim>& x) { return velocities(x); });
  soil.step();
  CellField<Real> volume(soil.problem.model.mesh.cell_count(), 0);
  soil.particles().visit([&](Index cell, Index b, int l) { volume[cell] += soil.particles().block(b).volume[l]; });
  for (const Index cell : soil.particles().occupied())
    for (const CornerSums<dim>& corner : soil.grid().corners[cell]) EXPECT_NEAR(corner.volume, volume[cell], 1e-13 * volume[cell]) << cell;
}

TYPED_TEST(VelocityFilter, is_not_in_elastic_bodies)
{
  constexpr int dim = TypeParam::value;
  auto velocities = noise<dim>();
  Drifting<dim> solid(sample_solid(), [&](const Vec<dim>& x) { return velocities(x); });
  const Real before = sums_over(solid.particles()).kinetic;
  for (int n = 0; n < 20; ++n) solid.step();
  EXPECT_NEAR(sums_over(solid.particles()).kinetic, before, 1e-12 * before);
}

}  // namespace
}  // namespace berm::mpm::this_file
