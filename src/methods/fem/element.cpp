// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

namespace berm::fem {
namespace {

/// What does not hang on the nodes.
struct ReferencePoint {
  AtSixNodes<Real> value;
  AtSixNodes<Vec<2>> derivative;
};

const std::array<ReferencePoint, triangle_points>& reference_points()
{
  static const std::array<ReferencePoint, triangle_points> points = [] {
    constexpr Real near = 1. / 6, far = 2. / 3;
    const Vec<2> at[triangle_points] = {{near, near}, {far, near}, {near, far}};
    std::array<ReferencePoint, triangle_points> made;
    for (int q = 0; q < triangle_points; ++q) made[q] = {shape_functions(at[q]), shape_derivatives(at[q])};
    return made;
  }();
  return points;
}

}  // namespace

ShapeAtPoint shape_at(const AtSixNodes<Vec<2>>& nodes, int point)
{
  const ReferencePoint& reference = reference_points()[static_cast<std::size_t>(point)];
  const Matrix<2> j = jacobian(nodes, reference.derivative), to_place = j.inverse().transpose();
  ShapeAtPoint shape;
  shape.value = reference.value;
  for (int k = 0; k < 6; ++k) shape.gradient[k] = to_place * reference.derivative[k];
  shape.area = j.determinant() / 6;
  shape.per_radius = 0;
  return shape;
}

Vec<2> position_of(const ShapeAtPoint& shape, const AtSixNodes<Vec<2>>& nodes)
{
  Vec<2> x = Vec<2>::Zero();
  for (int k = 0; k < 6; ++k) x += shape.value[k] * nodes[k];
  return x;
}

void turn_around_axis(ShapeAtPoint& shape, const Vec<2>& position)
{
  shape.per_radius = 1 / position[0];
  shape.area *= position[0];
}

}  // namespace berm::fem
