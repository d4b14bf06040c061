// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm {

/// Which way is up, said once: against gravity, along the axis nearest to it (y without gravity). The horizontal direction that u and H go along is the first
/// axis that is not up. Gravity may lean from the axis, as on a slope: then the bed's surface is level in the axes.
template <int dim>
struct Axes {
  int up = 1, along = 0;
  Real sign = 1;  ///< +1 where up is along +axis, else -1

  Vec<dim> up_vector() const
  {
    Vec<dim> v = Vec<dim>::Zero();
    v[up] = sign;
    return v;
  }
  /// How high a point lies, m.
  Real height(const Vec<dim>& x) const { return sign * x[up]; }
  /// How deep a point lies below a surface at that level of the vertical axis, m.
  Real depth(const Vec<dim>& x, Real surface) const { return sign * (surface - x[up]); }
};

template <int dim>
Axes<dim> axes_of(const Vec<dim>& gravity)
{
  Axes<dim> axes;
  if (gravity.isZero(0)) return axes;
  // Of equal parts the vertical axis y is taken.
  for (int d = 0; d < dim; ++d)
    if (std::abs(gravity[d]) > std::abs(gravity[axes.up])) axes.up = d;
  axes.along = axes.up == 0 ? 1 : 0;
  axes.sign = gravity[axes.up] > 0 ? -1 : 1;
  return axes;
}

}  // namespace berm
