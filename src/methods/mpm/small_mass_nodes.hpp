// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/small_mass_nodes_test.cpp
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// A node with less than this fraction of the mass that it has in cells full of soil is one of small mass: its forces are large for its mass, so that it may change its
/// direction of motion within a step.
inline constexpr Real small_mass_fraction = 0.05;

/// The largest stiffness over density of a cell for a step of dt (s), m2/s2:
///
///   2 / (dt^2 M sum_k |b_k|^2 / m_k),
///
/// with the mass M of its particles, the masses m_k of its nodes and the volumetric strain b_k that a displacement of node k makes: grad N_k, around an axis with 1/R
/// added in the radial direction, R the sum of the radii of the nodes. A node without mass follows the others; one on the axis has no radial displacement.
/// (docs/decisions/0097)
template <int dim>
Real max_stable_stiffness(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, Real dt)
{
  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  const auto& nodes = mesh.nodes[cell];
  const bool around_axis = mesh.metric == mesh::Metric::axisymmetric;
  Real radii = 0, mass = 0, of_corners = 0;
  for (int k = 0; k <= dim && around_axis; ++k) radii += mesh.position[nodes[k]][0];
  for (int k = 0; k <= dim; ++k) {
    mass += grid.corners[cell][k].mass;
    if (!(grid.mass[nodes[k]] > 0)) continue;
    Vec<dim> strain = shape.gradient(k);
    if (around_axis) strain[0] = mesh.position[nodes[k]][0] > 0 ? strain[0] + 1 / radii : 0;
    of_corners += strain.squaredNorm() / grid.mass[nodes[k]];
  }
  return 2 / (dt * dt * mass * of_corners);
}

/// The strain increment that the stress of a cell follows: the volumetric part times min(1, limit / bulk), the deviatoric part times
/// min(1, limit / shear), all m2/s2; all of it where limit is 0.
template <int dim>
[[gnu::always_inline]] inline SymTensor<dim> limited_strain(const SymTensor<dim>& strain, const settings::SoilWaves& soil, Real limit)
{
  if (limit == 0 || limit >= std::max(soil.bulk, soil.shear)) [[likely]]
    return strain;
  const Real mean = trace(strain) / 3, deviatoric = std::min<Real>(1, limit / soil.shear);
  const Real volumetric = std::min<Real>(1, limit / soil.bulk) - deviatoric;
  SymTensor<dim> limited;
  for (int k = 0; k < tensor_size<dim>; ++k) limited[k] = deviatoric * strain[k] + (k < 3 ? volumetric * mean : 0);
  return limited;
}

}  // namespace berm::mpm
