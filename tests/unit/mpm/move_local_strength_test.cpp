// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

material::MohrCoulomb weak_sand(Real friction_angle, Real cohesion, Real density)
{
  material::MohrCoulomb sand = sample_sand();
  sand.density = density;
  sand.friction_angle = friction_angle;
  sand.dilation_angle = friction_angle / 2;
  sand.cohesion = cohesion;
  return sand;
}

/// A body of one material.
problem::Problem<2> body_of_one(const material::Material& material, const mesh::Mesh<2>& mesh = criss_cross<2>())
{
  return problem_on<2>(mesh, material, 9);
}

/// The same particles; `number(p)` says which of two materials each has.
template <class Number>
problem::Problem<2> body_of_two(const material::Material& first, const material::Material& second, const Number& number,
                                const mesh::Mesh<2>& mesh = criss_cross<2>())
{
  problem::Problem<2> problem = body_of_one(first, mesh);
  settings::BodySoil& soil = problem.model.bodies[0].soil;
  soil.materials = {first, second};
  bodies::Particles<2> made(problem.model.mesh, problem.state.particles[0].size(), particle_extra(soil));
  problem.state.particles[0].visit([&](Index cell, Index b, int l) {
    bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    const std::size_t n = number(p);
    p.mass = p.volume * inertia_density(soil.materials[n]);
    const std::vector<Real> own = local_values(soil.materials[n]);
    std::copy(own.begin(), own.end(), p.extra + 1);
    p.extra[3] = static_cast<Real>(n);
    made.insert(cell, p);
  });
  made.sort_occupied();
  problem.state.particles[0] = std::move(made);
  return problem;
}

/// Stress under which all yield, then one step of shear and extension.
void shear_once(problem::Problem<2>& problem)
{
  for_each_particle(problem.state.particles[0], [&](bodies::Block<2>& p, int l) {
    for (int k = 0; k < 3; ++k) p.stress[k][l] = -1e4;
  });
  problem.model.mpm.volumetric_projection = false;
  problem.state.dt = 1e-3;
  Workspace<2> workspace(problem.model, problem.state);
  const mesh::Mesh<2>& mesh = problem.model.mesh;
  sum_moments(mesh, problem.state.particles[0], workspace.grids[0]);
  gather_mass_and_momentum(mesh, workspace.grids[0]);
  for (Index i = 0; i < mesh.node_count(); ++i)
    workspace.grids[0].mapped_velocity[i] = Vec<2>(20 * mesh.position[i][1], 5 * mesh.position[i][1]);
  move_and_strain(problem.model, problem.state, workspace, 0);
}

/// What a particle has after the step, by id.
std::map<std::int32_t, bodies::Particle<2>> by_id(const problem::Problem<2>& problem)
{
  std::map<std::int32_t, bodies::Particle<2>> found;
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    found[p.id] = p;
  });
  return found;
}

TEST(OwnSoil, strains_each_particle_by_its_own_material_also_where_a_cell_has_both)
{
  const material::MohrCoulomb loose = weak_sand(0.4, 500, 1500), dense = weak_sand(0.7, 3e3, 2000);
  const auto every_third = [](const bodies::Particle<2>& p) { return p.id % 3 == 0 ? 1u : 0u; };
  problem::Problem<2> both = body_of_two(loose, dense, every_third), all_loose = body_of_one(loose), all_dense = body_of_one(dense);
  for (problem::Problem<2>* problem : {&both, &all_loose, &all_dense}) shear_once(*problem);
  const auto found = by_id(both), as_loose = by_id(all_loose), as_dense = by_id(all_dense);
  Real apart = 0;
  for (const auto& [id, p] : found) {
    const bodies::Particle<2>& expected = id % 3 == 0 ? as_dense.at(id) : as_loose.at(id);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(p.stress[k], expected.stress[k], 1e-9 * 1e4) << "particle " << id;  // the modulus goes through a ratio
    EXPECT_NEAR(p.volume, expected.volume, 1e-12 * expected.volume);
    EXPECT_EQ(p.extra[3], id % 3 == 0 ? 1 : 0);
    apart = std::max(apart, std::abs(as_dense.at(id).stress[3] - as_loose.at(id).stress[3]));
  }
  EXPECT_GT(apart, 1e3);
}

TEST(OwnSoil, has_its_own_bounds_of_volume)
{
  const material::MohrCoulomb light = weak_sand(0.4, 500, 1000), heavy = weak_sand(0.4, 500, 3000);
  problem::Problem<2> problem = body_of_two(light, heavy, [](const bodies::Particle<2>& p) { return p.id % 2 == 0 ? 1u : 0u; });
  for_each_particle(problem.state.particles[0], [&](bodies::Block<2>& p, int l) { p.volume[l] *= 1.3; });  // beyond the largest volume, 1.2
  shear_once(problem);
  for (const auto& [id, p] : by_id(problem))
    EXPECT_NEAR(p.volume * (id % 2 == 0 ? 3000 : 1000) / p.mass, problem.model.mpm.max_volume_ratio, 1e-12);
}

/// A mesh whose cells grow along x.
mesh::Mesh<2> cells_of_many_sizes()
{
  mesh::Mesh<2> mesh = criss_cross<2>();
  const Real begin = mesh.lower[0], length = mesh.upper[0] - mesh.lower[0];
  for (Index node = 0; node < mesh.node_count(); ++node) {
    Real& x = mesh.position[node][0];
    x = begin + (x - begin) * (0.5 + 0.5 * (x - begin) / length);
  }
  return mesh;
}

TEST(CellFriction, is_that_of_the_cell_in_which_a_particle_is)
{
  material::MohrCoulomb sand = weak_sand(0.9, 500, 1500);
  sand.dilation_angle = 0;
  sand.band_width = 0.5;
  const mesh::Mesh<2> cells = cells_of_many_sizes();
  Real smallest = infinity, largest = 0;
  for (Index cell = 0; cell < cells.cell_count(); ++cell)
    smallest = std::min(smallest, cells.size(cell)), largest = std::max(largest, cells.size(cell));
  ASSERT_GT(largest, 1.3 * smallest);
  for (const bool local : {false, true}) {
    if (local) sand.cohesion_gradient = 10;
    const auto body_of = [&](const material::MohrCoulomb& soil) {
      return local ? body_of_two(
                         soil, soil, [](const bodies::Particle<2>&) { return 0u; }, cells)
                   : body_of_one(soil, cells);
    };
    // All particles with the friction of cells of one size.
    const auto all_in_cells_of = [&](Real size) {
      material::MohrCoulomb here = regularised_for(sand, size);
      here.cohesion_share = 1;  // a soil of its own: its particles keep its cohesion
      problem::Problem<2> alike = body_of(here);
      shear_once(alike);
      return by_id(alike);
    };
    const auto apart = [](const bodies::Particle<2>& p, const bodies::Particle<2>& q) {
      Real most = 0;
      for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(p.stress[k] - q.stress[k]));
      return most;
    };
    problem::Problem<2> of_cells = body_of(sand);
    shear_once(of_cells);
    const auto in_smallest = all_in_cells_of(smallest), in_largest = all_in_cells_of(largest);
    std::map<int, std::map<std::int32_t, bodies::Particle<2>>> in_class;
    of_cells.state.particles[0].visit([&](Index cell, Index b, int l) {
      const bodies::Particle<2> p = of_cells.state.particles[0].read(b, l);
      const Real size = of_cells.model.mesh.size(cell), range = apart(in_smallest.at(p.id), in_largest.at(p.id));
      const int number = static_cast<int>(std::lround(100 * std::log(size)));
      if (in_class.count(number) == 0) in_class[number] = all_in_cells_of(size);
      EXPECT_GT(range, 20) << "Pa: another class would be seen";
      EXPECT_LT(apart(p, in_class[number].at(p.id)), range / 10) << size;  // of some 55 classes between them, one
    });
  }
}

}  // namespace
}  // namespace berm::mpm::this_file
