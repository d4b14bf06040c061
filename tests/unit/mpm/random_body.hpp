// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm {

/// Where meshes of tests lie: at the origin, and at survey coordinates. Sums from a corner of the cell have as many digits there.
constexpr Real places[] = {0, 6'543'210.987};

/// A body of half the mesh whose particles have masses, velocities, volumes and stresses at random.
template <int dim>
struct RandomBody {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;

  /// All coordinates larger by `place`.
  explicit RandomBody(Real place = 0) : problem(make(place)), workspace(problem.model, problem.state)
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
  static problem::Problem<dim> make(Real place)
  {
    mesh::Mesh<dim> mesh = shaken_box<dim>();
    for (Vec<dim>& x : mesh.position) x += Vec<dim>::Constant(place);
    mesh.complete();
    auto problem = problem_on<dim>(mesh, sample_solid(), 0);
    // Cells of the upper half become empty, and with them some nodes.
    bodies::Particles<dim>& all = problem.state.particles[0];
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      while (mesh.centroid(cell)[1] > place + 0.8 && all.count_in(cell) > 0) all.take(cell, 0);
    all.sort_occupied();
    return problem;
  }

  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  const mesh::Mesh<dim>& mesh() const { return problem.model.mesh; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }
  problem::State<dim>& state() { return problem.state; }

  void to_the_nodes(bool project)
  {
    problem.model.mpm.volumetric_projection = project;
    sum_moments(mesh(), particles(), grid());
    gather_mass_and_momentum(mesh(), grid());
    spread_internal_forces(problem.model, particles(), 0, grid());
  }
  Vec<dim> force(Index node) const
  {
    Vec<dim> f = Vec<dim>::Zero();
    for (Index e = mesh().first_entry[node]; e < mesh().first_entry[node + 1]; ++e)
      f += Eigen::Map<const Vec<dim>>(workspace.grids[0].at(mesh().entries[e]).sum);
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
class OfRandomBody : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

}  // namespace berm::mpm
