// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

material::MohrCoulomb dilating(Real dilation_angle)
{
  material::MohrCoulomb law = sample_sand();
  law.dilation_angle = dilation_angle;
  return law;
}

/// A body at rest whose cells have pressures of their own, far below failure, after a step in which nothing moves.
template <int dim>
struct Resting {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;
  CellField<Real> before, after;  ///< mean stress of the cells in the directions of the mesh, Pa
  Real energy_before, energy_after;

  Resting(const mesh::Mesh<dim>& mesh, const material::MohrCoulomb& law)
      : problem(problem_on<dim>(mesh, law, dim == 2 ? 9 : 8)),
        workspace(problem.model, problem.state),
        law_(law)
  {
    std::mt19937 random(3);
    const CellField<Real> pressure = [&] {
      CellField<Real> made(mesh.cell_count(), 0);
      for (Real& p : made) p = std::uniform_real_distribution<Real>(1e4, 1.2e4)(random);
      return made;
    }();
    for (const Index cell : particles().occupied())
      for (const auto& [p, b, count] : particles().blocks_in(cell))
        for (int l = 0; l < count; ++l)
          for (int a = 0; a < 3; ++a) p.stress[a][l] = -pressure[cell] * (a == 1 ? 1.1 : 1);
    before = means(), energy_before = elastic_energy();
    problem.state.dt = 1e-3;
    sum_moments(mesh, particles(), grid());
    gather_mass_and_momentum(mesh, grid());
    spread_internal_forces(problem.model, particles(), 0, grid());
    for (Index i = 0; i < mesh.node_count(); ++i) grid().mapped_velocity[i].setZero();
    sum_volume_changes(mesh, particles(), problem.state.dt, grid());
    move_and_strain(problem.model, problem.state, workspace, 0);
    after = means(), energy_after = elastic_energy();
  }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }

private:
  material::MohrCoulomb law_;

  CellField<Real> means()
  {
    sum_moments(problem.model.mesh, particles(), grid());
    CellField<Real> found(problem.model.mesh.cell_count(), 0);
    for (const Index cell : particles().occupied()) {
      for (int d = 0; d < dim; ++d) found[cell] += grid().moments[cell].stress[Moments<dim>::pair(d, d)] / dim;
      found[cell] /= grid().moments[cell].volume;
    }
    return found;
  }
  Real elastic_energy()
  {
    Real energy = 0;
    for_each_particle(particles(), [&](bodies::Block<dim>& p, int l) {
      Real squares = 0, trace = 0;
      for (int a = 0; a < 3; ++a) squares += p.stress[a][l] * p.stress[a][l], trace += p.stress[a][l];
      energy += p.volume[l] / (2 * law_.young_modulus) * ((1 + law_.poisson_ratio) * squares - law_.poisson_ratio * trace * trace);
    });
    return energy;
  }
};

template <class Dimension>
class SharedPressure : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SharedPressure, Dimensions);

// No tolerance but that of the numbers: the cells of a patch get its mean, and what one gains the others lose.
TYPED_TEST(SharedPressure, cells_of_a_patch_of_dilating_soil_have_one_pressure_and_lose_elastic_energy)
{
  constexpr int dim = TypeParam::value;
  Resting<dim> soil(shaken_box<dim>(), dilating(0.3));
  const mesh::Mesh<dim>& mesh = soil.problem.model.mesh;
  Real most = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Real volume = 0, of_patch = 0;
    mesh::for_each_in_patch(soil.problem.model.patches, cell, [&](Index member) {
      volume += soil.grid().moments[member].volume;
      of_patch += soil.grid().moments[member].volume * soil.before[member];
    });
    EXPECT_NEAR(soil.after[cell], of_patch / volume, 1e-9 * std::abs(soil.before[cell]));
    most = std::max(most, std::abs(soil.after[cell] - soil.before[cell]));
  }
  EXPECT_GT(most, 300);  // Pa, of cells that differ by up to 2000
  EXPECT_LT(soil.energy_after, soil.energy_before);
}

TYPED_TEST(SharedPressure, soil_that_does_not_dilate_keeps_its_pressures)
{
  constexpr int dim = TypeParam::value;
  Resting<dim> soil(shaken_box<dim>(), dilating(0));
  for (Index cell = 0; cell < soil.problem.model.mesh.cell_count(); ++cell) EXPECT_EQ(soil.after[cell], soil.before[cell]);
}

}  // namespace
}  // namespace berm::mpm::this_file
