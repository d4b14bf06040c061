// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The values of a nodal field at the corners of a cell.
template <int dim>
[[gnu::always_inline]] inline AtCorners<dim> at_corners(const std::array<Index, dim + 1>& nodes, const NodeField<Vec<dim>>& field)
{
  const Vec<dim>* values = field.data();
  AtCorners<dim> made;
  for (int k = 0; k <= dim; ++k) made[k] = components(values[nodes[k]]);
  return made;
}

/// A nodal vector field within a cell, where it is linear: field(x) = c + sum_a slope[a] x_a, with x from corner 0.
template <int dim>
struct LinearField {
  Components<dim> c, slope[dim];

  [[gnu::always_inline]] LinearField(const mesh::Gradients<dim>& gradients, const AtCorners<dim>& values) : c(values[0])
  {
    for (int k = 1; k <= dim; ++k) {
      const Components<dim> difference = values[k] - c;
      for (int a = 0; a < dim; ++a) slope[a] = k == 1 ? gradients[0][a] * difference : slope[a] + gradients[k - 1][a] * difference;
    }
  }
  /// Component d at x from corner 0.
  template <class V>
  [[gnu::always_inline]] V at(int d, const V* x) const
  {
    V value = c[d] + slope[0][d] * x[0];
    for (int a = 1; a < dim; ++a) value += slope[a][d] * x[a];
    return value;
  }
};

/// The velocity at the corners of a cell that its particles gain in step 5, apart from the part of their own that the filter takes out, m/s: dt a + part v2, and
/// what they get back.
template <int dim>
[[gnu::always_inline]] inline AtCorners<dim> velocity_gain(const AtCorners<dim>& acceleration, const std::array<Index, dim + 1>& nodes,
                                                           const BodyGrid<dim>& grid, Real dt, const FilterOfCell<dim>& filter)
{
  const AtCorners<dim> smooth = at_corners(nodes, grid.smooth_velocity);
  const Components<dim> shift = components(filter.shift);
  AtCorners<dim> gain;
  for (int k = 0; k <= dim; ++k) gain[k] = shift + dt * acceleration[k] + filter.fraction * smooth[k];
  return gain;
}

}  // namespace berm::mpm
