// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/cut_cells.hpp"

#include "material/linear_elastic.hpp"
#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "mpm/quadrature.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

constexpr Real p = 1e3;  // Pa, in all of the soil

/// Soil in a box of 1 m with squares of 0.1 m, to the right of a wall that ends at x = face; one particle in thirty is missing.
problem::Problem<2> beside_wall(Real face, settings::Quadrature quadrature)
{
  settings::Case c;
  mesh::BoxMesh box;
  box.size = {1, 1};
  box.cells = {10, 10};
  c.mesh = box;
  material::LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e6;
  c.material = {{"solid", law}};
  bodies::BodySettings body;
  body.material = "solid";
  body.regions = {"box"};
  body.particles_per_cell = 9;
  c.body = {{"soil", body}};
  c.gravity = {0, 0};
  bodies::BoxSettings shape;
  shape.center = {face - 1, 0.5};
  shape.size = {2, 4};
  bodies::RigidSettings wall;
  wall.shape = shape;
  c.rigid = {{"wall", wall}};
  contact::ContactSettings contact;
  contact.body = "soil";
  contact.rigid = "wall";
  c.contact = {{"skin", contact}};
  c.mpm.quadrature = quadrature;
  settings::StageSettings rest;
  rest.name = "rest";
  rest.until.time = 1;
  c.stage = {rest};
  problem::Problem<2> problem = problem::build<2>(c, ".", ".");
  bodies::Particles<2>& particles = problem.state.particles[0];
  for (Index cell = 0; cell < problem.model.mesh.cell_count(); ++cell)
    for (Index place = particles.count_in(cell); place-- > 0;)
      if (particles.read_at(cell, place).id % 30 == 5) particles.take(cell, place);
  particles.sort_occupied();
  particles.visit([&](Index, Index b, int l) {
    for (int k = 0; k < 3; ++k) particles.block(b).stress[k][l] = -p;
  });
  return problem;
}

/// The sum of the nodal forces on the soil beside the wall, of so many rows of nodes in the middle, and the largest force of a node away from it.
struct Forces {
  Vec<2> at_wall = Vec<2>::Zero();
  Real inside = 0;

  explicit Forces(problem::Problem<2> problem)
  {
    const mesh::Mesh<2>& mesh = problem.model.mesh;
    Workspace<2> workspace(problem.model, problem.state);
    BodyGrid<2>& grid = workspace.grids[0];
    sum_moments(mesh, problem.state.particles[0], grid);
    gather_mass_and_momentum(mesh, grid);
    find_cut_cells(problem.model, problem.state, 0, grid);
    prepare_cells(problem.model, problem.state.particles[0], 0, grid);
    spread_internal_forces(problem.model, problem.state.particles[0], 0, grid);
    for (Index node = 0; node < mesh.node_count(); ++node) {
      const Vec<2>& x = mesh.position[node];
      if (x[1] < 0.15 || x[1] > 0.85 || x[0] > 0.95) continue;
      Vec<2> force = Vec<2>::Zero();
      for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e)
        force += Eigen::Map<const Vec<2>>(grid.at(mesh.entries[e]).sum);
      if (x[0] < 0.45)
        at_wall += force;
      else
        inside = std::max(inside, force.norm());
    }
  }
};

// Seven rows of nodes 0.1 m apart; round-off of sums of a hundred such forces.
TEST(CutCells, beside_a_wall_push_with_the_pressure_of_the_soil_wherever_particles_lie_and_the_wall_cuts_them)
{
  for (const Real face : {0.3, 0.32, 0.35, 0.38}) {
    const Forces cut(beside_wall(face, settings::Quadrature::cut_cells));
    EXPECT_NEAR(std::abs(cut.at_wall[0]), 0.7 * p, 1e-10 * p) << face;
    EXPECT_NEAR(cut.at_wall[1], 0, 1e-10 * p) << face;
    EXPECT_LT(cut.inside, 1e-10 * p) << face;
  }
}

TEST(CutCells, are_none_unless_they_are_asked_for)
{
  const Forces whole(beside_wall(0.3, settings::Quadrature::full_cells));
  EXPECT_GT(std::abs(std::abs(whole.at_wall[0]) - 0.7 * p) + std::abs(whole.at_wall[1]), 1e-3 * p) << "particles are missing at the wall";
}

}  // namespace
}  // namespace berm::mpm::this_file
