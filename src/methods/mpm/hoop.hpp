// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/axisymmetry.cpp
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Calls give(k, a_k) for the corners of a cell: a_k = sum A N_k over its particles, A = V / r, m2.
template <int dim, class Give>
[[gnu::always_inline]] inline void for_each_hoop_share(const mesh::Shape<dim>& shape, const Moments<dim>& t, const HoopMoments& hoop,
                                                       const Give& give)
{
  const Real from_origin[2] = {t.volume - hoop.area * shape.origin[0], hoop.area_y};
  Real of_corner_0 = hoop.area;
  for (int k = 1; k <= dim; ++k) {
    const Real share = shape.gradients[k - 1][0] * from_origin[0] + shape.gradients[k - 1][1] * from_origin[1];
    give(k, share);
    of_corner_0 -= share;
  }
  give(0, of_corner_0);
}

/// Rate of hoop strain of a cell, one for all its particles: sum_k a_k v_r,k / V, 1/s. For v_r = c r it is c, wherever the particles are; v_r / r of single
/// particles would have no bound at the axis.
template <int dim>
[[gnu::always_inline]] inline Real hoop_rate(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes,
                                             const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& velocity)
{
  const Moments<dim>& t = grid.moments[cell];
  Real sum = 0;
  for_each_hoop_share<dim>(shape, t, grid.hoop[cell], [&](int k, Real share) { sum += share * velocity[nodes[k]][0]; });
  return sum / t.volume;
}

/// Calls act(metric) with the metric of the mesh as a compile-time constant. In space there is one.
template <int dim, class Act>
[[gnu::always_inline]] inline decltype(auto) with_metric(const mesh::Mesh<dim>& mesh, const Act& act)
{
  using enum mesh::Metric;
  if constexpr (dim == 2)
    if (mesh.metric == axisymmetric) return act(std::integral_constant<mesh::Metric, axisymmetric>());
  return act(std::integral_constant<mesh::Metric, cartesian>());
}

/// What a pressure of 1 Pa in the soil of a cell does at its corners, N: V grad N_k, and a_k along the radius around an axis.
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline std::array<Vec<dim>, dim + 1> forces_of_pressure(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid,
                                                                               Index cell)
{
  const Moments<dim>& t = grid.moments[cell];
  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  std::array<Vec<dim>, dim + 1> forces;
  for (int k = 0; k <= dim; ++k) forces[k] = t.volume * shape.gradient(k);
  if constexpr (metric == mesh::Metric::axisymmetric)
    for_each_hoop_share<dim>(shape, t, grid.hoop[cell], [&](int k, Real share) { forces[k][0] += share; });
  return forces;
}

/// Directions with a strain of their own in the volume change that patches share.
template <int dim, mesh::Metric metric>
constexpr int strained_directions = metric == mesh::Metric::axisymmetric ? 3 : dim;

}  // namespace berm::mpm
