// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/fill.hpp"
#include "mpm/grid.hpp"

#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "samples/sample_meshes.hpp"

namespace berm::mpm {

inline material::LinearElastic sample_solid(Real poisson_ratio = 0.3)
{
  material::LinearElastic law;
  law.density = 1500;
  law.young_modulus = 2e6;
  law.poisson_ratio = poisson_ratio;
  return law;
}

/// Sand of the same stiffness, without cohesion and dilation.
inline material::MohrCoulomb sample_sand()
{
  const material::LinearElastic solid = sample_solid();
  material::MohrCoulomb law;
  law.density = solid.density;
  law.young_modulus = solid.young_modulus;
  law.poisson_ratio = solid.poisson_ratio;
  law.friction_angle = 0.6;
  return law;
}

/// One body that fills all regions of a mesh with n^dim particles a cell; no supports, no gravity, no rigid body.
template <int dim>
problem::Problem<dim> problem_on(const mesh::Mesh<dim>& mesh, const material::Material& material, int particles_per_cell)
{
  problem::Problem<dim> problem;
  problem::Model<dim>& model = problem.model;
  model.mesh = mesh;
  model.patches = make_patches(mesh);
  model.bodies.push_back({"body", settings::soil_of_one(material), NodeField<Real>(mesh.node_count(), 0)});
  make_tables(mesh.node_count(), 1, model.water_flows(), model.conditions);
  model.mpm.quadrature = settings::Quadrature::particles;
  model.gravity = Vec<dim>::Zero();
  model.gravity_ramp = model.surface = 0;
  model.stages.emplace_back();
  model.stages[0].until.time = infinity;
  model.driven = {none};
  model.main_rigid = none;
  bodies::BodySettings body;
  body.regions = mesh.region_names;
  body.particles_per_cell = particles_per_cell;
  problem.state.particles.push_back(fill<dim>(mesh, "body", body, {density(material), 0, 0, state_fields(material)}));
  return problem;
}

template <int dim>
mesh::Mesh<dim> criss_cross();
template <>
inline mesh::Mesh<2> criss_cross<2>()
{
  return make_box<2>(sample_box<2>(mesh::BoxPattern::criss_cross));
}

/// Calls change(block, lane) for each particle.
template <int dim, class Change>
void for_each_particle(bodies::Particles<dim>& particles, const Change& change)
{
  particles.visit([&](Index, Index b, int l) { change(particles.block(b), l); });
}

template <int dim>
Vec<dim> position(const bodies::Block<dim>& block, int lane)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = block.x[d][lane];
  return x;
}
template <int dim>
Vec<dim> velocity(const bodies::Block<dim>& block, int lane)
{
  Vec<dim> v;
  for (int d = 0; d < dim; ++d) v[d] = block.v[d][lane];
  return v;
}
template <int dim>
void set_velocity(bodies::Block<dim>& block, int lane, const Vec<dim>& v)
{
  for (int d = 0; d < dim; ++d) block.v[d][lane] = v[d];
}

/// Whether a node lies on a boundary of the mesh.
template <int dim>
NodeField<char> boundary_flags(const mesh::Mesh<dim>& mesh)
{
  NodeField<char> flags(mesh.node_count(), 0);
  for (const auto& list : mesh.boundary_nodes)
    for (Index i : list) flags[i] = 1;
  return flags;
}

template <int dim>
Matrix<dim> random_matrix(std::mt19937& random)
{
  Matrix<dim> m;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) m(a, b) = std::uniform_real_distribution<Real>(-1, 1)(random);
  return m;
}

}  // namespace berm::mpm
