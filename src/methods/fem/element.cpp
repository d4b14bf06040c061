// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

namespace berm::fem {

ShapeAtPoint shape_at(const AtSixNodes<Vec<2>>& nodes, int point)
{
  constexpr Real near = 1. / 6, far = 2. / 3;
  const Vec<2> at[triangle_points] = {{near, near}, {far, near}, {near, far}};
  const Matrix<2> j = jacobian(nodes, at[point]), to_place = j.inverse().transpose();
  const AtSixNodes<Vec<2>> derivatives = shape_derivatives(at[point]);
  ShapeAtPoint shape;
  shape.value = shape_functions(at[point]);
  for (int k = 0; k < 6; ++k) shape.gradient[k] = to_place * derivatives[k];
  shape.area = j.determinant() / 6;
  shape.per_radius = 0;
  return shape;
}

}  // namespace berm::fem
