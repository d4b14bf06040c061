// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/quadrature.hpp"

#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// A box of solid whose cells hold unequal numbers of particles, up to the nodal forces of step 1.
template <int dim>
struct Uneven {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;

  /// keep(x) says which particles of the filled box are there, volume(x) how large they are over their first volume.
  template <class Stress, class Keep>
  Uneven(settings::Quadrature quadrature, const Stress& stress, const Keep& keep)
      : problem(prepared(quadrature, stress, keep)),
        workspace(problem.model, problem.state)
  {
    sum_moments(mesh(), particles(), grid());
    gather_mass_and_momentum(mesh(), grid());
    prepare_cells(problem.model, particles(), 0, grid());
    spread_internal_forces(problem.model, particles(), 0, grid());
  }

  template <class Stress, class Kept>
  static problem::Problem<dim> prepared(settings::Quadrature quadrature, const Stress& stress, const Kept& keep)
  {
    auto made = problem_on<dim>(shaken_box<dim>(), sample_solid(), dim == 2 ? 9 : 27);
    made.model.mpm.quadrature = quadrature;
    bodies::Particles<dim>& particles = made.state.particles[0];
    for (Index cell = 0; cell < made.model.mesh.cell_count(); ++cell)
      for (Index place = particles.count_in(cell); place-- > 0;)
        if (!keep(particles.read_at(cell, place))) particles.take(cell, place);
    particles.sort_occupied();
    for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
      const SymTensor<dim> s = stress(position<dim>(p, l));
      for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = s[k];
    });
    return made;
  }
  const mesh::Mesh<dim>& mesh() const { return problem.model.mesh; }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }

  Vec<dim> force(Index node)
  {
    Vec<dim> sum = Vec<dim>::Zero();
    for (Index e = mesh().first_entry[node]; e < mesh().first_entry[node + 1]; ++e)
      sum += Eigen::Map<const Vec<dim>>(grid().at(mesh().entries[e]).sum);
    return sum;
  }
};

template <int dim>
SymTensor<dim> pressure(const Vec<dim>&)
{
  SymTensor<dim> stress{};
  for (int d = 0; d < 3; ++d) stress[d] = -1e3;
  return stress;
}

/// One particle in thirty is missing: every cell is nearly full, but not all alike.
template <int dim>
bool with_gaps(const bodies::Particle<dim>& p)
{
  return p.id % 30 != 5;
}

template <class Dimension>
class FullCells : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FullCells, Dimensions);

TYPED_TEST(FullCells, carry_a_uniform_stress_without_forces_inside_however_particles_lie)
{
  constexpr int dim = TypeParam::value;
  const auto largest_inside = [](settings::Quadrature quadrature) {
    Uneven<dim> soil(quadrature, pressure<dim>, with_gaps<dim>);
    const auto boundary = boundary_flags(soil.mesh());
    Real largest = 0, at_boundary = 0;
    for (Index i = 0; i < soil.mesh().node_count(); ++i) {
      Real& which = boundary[i] != 0 ? at_boundary : largest;
      which = std::max(which, soil.force(i).norm());
    }
    return largest / at_boundary;
  };
  EXPECT_LT(largest_inside(settings::Quadrature::full_cells), 1e-13);
  EXPECT_GT(largest_inside(settings::Quadrature::particles), 1e-2);
}

TYPED_TEST(FullCells, leave_the_cells_at_a_free_surface_to_their_particles)
{
  constexpr int dim = TypeParam::value;
  const Real level = 0.5 * (shaken_box<dim>().lower[1] + shaken_box<dim>().upper[1]);
  Uneven<dim> soil(settings::Quadrature::full_cells, pressure<dim>, [&](const bodies::Particle<dim>& p) { return p.x[1] < level; });
  Index at_surface = 0, inside = 0;
  for (Index cell : soil.particles().occupied()) {
    bool cut = false, whole = true;
    for (Index node : soil.mesh().nodes[cell]) {
      cut = cut || soil.grid().fill[node] <= 0.75;
      whole = whole && soil.grid().fill[node] >= 0.9;
    }
    if (cut) {
      EXPECT_EQ(soil.grid().weight(cell), 1);
    }
    if (whole) {
      EXPECT_NEAR(soil.grid().moments[cell].volume, soil.mesh().volume(cell), 1e-12 * soil.mesh().volume(cell));
    }
    at_surface += cut;
    inside += whole;
  }
  EXPECT_GT(at_surface, 0);
  EXPECT_GT(inside, 0);
}

TYPED_TEST(FullCells, do_the_work_of_the_nodal_forces)
{
  constexpr int dim = TypeParam::value;
  Uneven<dim> soil(
      settings::Quadrature::full_cells,
      [](const Vec<dim>& x) {
        SymTensor<dim> stress{};
        for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = 1e3 * std::sin(k + 3 * x[0] - 2 * x[1]);
        return stress;
      },
      with_gaps<dim>);
  soil.problem.state.dt = 1e-13;  // the stress of the increment is lost in that of the start
  Real power = 0;
  for (Index i = 0; i < soil.mesh().node_count(); ++i) {
    const Vec<dim>& x = soil.mesh().position[i];
    for (int d = 0; d < dim; ++d) soil.grid().mapped_velocity[i][d] = std::cos(5 * x[d] + 2 * x[(d + 1) % dim]);
    power += soil.force(i).dot(soil.grid().mapped_velocity[i]);
  }
  sum_volume_changes(soil.mesh(), soil.particles(), soil.problem.state.dt, soil.grid());
  move_and_strain(soil.problem.model, soil.problem.state, soil.workspace, 0);
  EXPECT_NEAR(soil.problem.state.ledger.totals.internal / soil.problem.state.dt, -power, 1e-4 * std::abs(power));
}

}  // namespace
}  // namespace berm::mpm::this_file
