// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/light_corners_test.cpp
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The stiffness over density that a cell can have in a step of dt (s), m2/s2:
///
///   2 / (dt^2 M sum_k (|grad N_k|^2 + 1/R^2) / m_k),
///
/// with the mass M of its particles, the masses m_k of its nodes and, around an axis alone, the hoop strain 1/R that a radial displacement of 1 m makes, R the sum
/// of the radii of the nodes. A particle that is alone has one velocity, so that its nodes forget in each step how they moved apart; one stress is multiplied by
/// 1 - 2 (its stiffness over density) / (this), which must not be less than -1. The sum is large where a node has little mass, because the only particles around it
/// are far away. A node without mass follows the others, and one on the axis does not move away from it. (docs/decisions/0097)
template <int dim>
Real bearable_stiffness(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, Real dt)
{
  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  const auto& nodes = mesh.nodes[cell];
  Real radii = 0, mass = 0, of_corners = 0;
  if (mesh.metric == mesh::Metric::axisymmetric)
    for (const Index node : nodes) radii += mesh.position[node][0];
  for (int k = 0; k <= dim; ++k) {
    mass += grid.corners[cell][k].mass;
    if (!(grid.mass[nodes[k]] > 0)) continue;
    const Real hoop = radii > 0 && mesh.position[nodes[k]][0] > 0 ? 1 / (radii * radii) : 0;
    of_corners += (shape.gradient(k).squaredNorm() + hoop) / grid.mass[nodes[k]];
  }
  return 2 / (dt * dt * mass * of_corners);
}

/// The strain that the stress of a cell follows: its volumetric and its deviatoric part, each less where the body's soil is stiffer against it than the cell can be
/// (m2/s2).
template <int dim>
[[gnu::always_inline]] inline SymTensor<dim> followed_strain(const SymTensor<dim>& strain, const problem::SoilWaves& soil, Real bearable)
{
  if (bearable >= std::max(soil.bulk, soil.shear)) [[likely]]
    return strain;
  const Real mean = trace(strain) / 3, deviatoric = std::min<Real>(1, bearable / soil.shear);
  const Real volumetric = std::min<Real>(1, bearable / soil.bulk) - deviatoric;
  SymTensor<dim> followed;
  for (int k = 0; k < tensor_size<dim>; ++k) followed[k] = deviatoric * strain[k] + (k < 3 ? volumetric * mean : 0);
  return followed;
}

}  // namespace berm::mpm
