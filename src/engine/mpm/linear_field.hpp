// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// A nodal vector field within a cell, where it is linear: field_d(x) = c[d] + sum_a slope[d][a] x_a, with x from corner 0.
template <int dim>
struct LinearField {
  Real c[dim], slope[dim][dim] = {};

  /// Of the numbers value(node, d) at the cell's nodes.
  template <class Value>
  [[gnu::always_inline]] LinearField(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes, const Value& value)
  {
    for (int d = 0; d < dim; ++d) {
      const Real first = value(nodes[0], d);
      for (int k = 1; k <= dim; ++k) {
        const Real difference = value(nodes[k], d) - first;
        for (int a = 0; a < dim; ++a) slope[d][a] += shape.gradients[k - 1][a] * difference;
      }
      c[d] = first;
    }
  }
  [[gnu::always_inline]] LinearField(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes,
                                     const NodeField<Vec<dim>>& field)
      : LinearField(shape, nodes, [&](Index i, int d) { return field[i][d]; })
  {
  }
  /// At x from corner 0.
  template <class V>
  [[gnu::always_inline]] V at(int d, const V* x) const
  {
    V value = c[d] + slope[d][0] * x[0];
    for (int a = 1; a < dim; ++a) value += slope[d][a] * x[a];
    return value;
  }
  /// The sum of m field . v over the particles of the cell, given sum m v and sum m v x of any velocities v, with x from corner 0.
  [[gnu::always_inline]] Real dot(const Real (&mv)[dim], const Real (&mvx)[dim][dim]) const
  {
    Real sum = 0;
    for (int d = 0; d < dim; ++d) {
      sum += c[d] * mv[d];
      for (int a = 0; a < dim; ++a) sum += slope[d][a] * mvx[d][a];
    }
    return sum;
  }
  /// The sum of m field_d over the particles of the cell, and that of m field_d x as times_x, from the cell's moments.
  [[gnu::always_inline]] Real momentum(int d, const Moments<dim>& t, Real (&times_x)[dim]) const
  {
    Real sum = c[d] * t.m;
    for (int a = 0; a < dim; ++a) sum += slope[d][a] * t.mx[a];
    for (int b = 0; b < dim; ++b) {
      times_x[b] = c[d] * t.mx[b];
      for (int a = 0; a < dim; ++a) times_x[b] += slope[d][a] * t.mxx[Moments<dim>::pair(std::min(a, b), std::max(a, b))];
    }
    return sum;
  }
};

/// The velocity that particles of a cell gain in step 5, apart from the part of their own that the filter takes out, m/s: dt a + part v2, and what they get back.
template <int dim>
[[gnu::always_inline]] inline LinearField<dim> velocity_gain(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes,
                                                             const BodyGrid<dim>& grid, Real dt, const FilterOfCell<dim>& filter)
{
  LinearField<dim> gain(shape, nodes,
                        [&](Index i, int d) { return dt * grid.acceleration[i][d] + filter.part * grid.smooth_velocity[i][d]; });
  for (int d = 0; d < dim; ++d) gain.c[d] += filter.shift[d];
  return gain;
}

}  // namespace berm::mpm
