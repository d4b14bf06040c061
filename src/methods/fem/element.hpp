// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

#include <Eigen/LU>
#include <array>

namespace berm::fem {

/// A value for each node of a 6-node triangle: corners counter-clockwise, then the mid-side nodes of 01, 12 and 20.
template <class T>
using AtSixNodes = std::array<T, 6>;

/// Coordinates of the nodes in the reference triangle 0 <= r, s, r + s <= 1.
inline const AtSixNodes<Vec<2>> six_nodes{Vec<2>{0, 0}, Vec<2>{1, 0}, Vec<2>{0, 1}, Vec<2>{0.5, 0}, Vec<2>{0.5, 0.5}, Vec<2>{0, 0.5}};

/// The quadratic shape functions at (r, s): l_k (2 l_k - 1) for the corners, 4 l_j l_k for the mid-side nodes, with l = (1 -
/// r - s, r, s).
inline AtSixNodes<Real> shape_functions(const Vec<2>& at)
{
  const Real l0 = 1 - at[0] - at[1], l1 = at[0], l2 = at[1];
  return {l0 * (2 * l0 - 1), l1 * (2 * l1 - 1), l2 * (2 * l2 - 1), 4 * l0 * l1, 4 * l1 * l2, 4 * l2 * l0};
}

/// Their derivatives with respect to (r, s).
inline AtSixNodes<Vec<2>> shape_derivatives(const Vec<2>& at)
{
  const Real l0 = 1 - at[0] - at[1], l1 = at[0], l2 = at[1];
  return {Vec<2>{1 - 4 * l0, 1 - 4 * l0}, Vec<2>{4 * l1 - 1, 0},  Vec<2>{0, 4 * l2 - 1},
          Vec<2>{4 * (l0 - l1), -4 * l1}, Vec<2>{4 * l2, 4 * l1}, Vec<2>{-4 * l2, 4 * (l0 - l2)}};
}

/// The Jacobian: column d is dx/dr or dx/ds, m. Its determinant is the area per unit of (r, s), twice that of a triangle
/// with straight sides.
inline Matrix<2> jacobian(const AtSixNodes<Vec<2>>& x, const AtSixNodes<Vec<2>>& derivatives)
{
  Matrix<2> sum = Matrix<2>::Zero();
  // From corner 0, whose own derivatives the others balance: no digits are lost far from the origin.
  for (int k = 1; k < 6; ++k) sum += (x[k] - x[0]) * derivatives[k].transpose();
  return sum;
}

inline Matrix<2> jacobian(const AtSixNodes<Vec<2>>& x, const Vec<2>& at)
{
  return jacobian(x, shape_derivatives(at));
}

/// Stiffness of an element: the lower triangle of its 12 x 12 entries, row by row.
using CellStiffness = std::array<Real, 78>;

/// Integration points of a 6-node triangle: three, exact for polynomials of degree 2 on straight sides; with three the
/// element does not lock at constant volume.
constexpr int triangle_points = 3;

/// The shape functions of a 6-node triangle at one integration point.
struct ShapeAtPoint {
  AtSixNodes<Real> value;
  AtSixNodes<Vec<2>> gradient;  ///< 1/m
  Real area;                    ///< m2, share of the element; around an axis m3, times the radius
  Real per_radius;              ///< 1/m, 1/r around an axis; else 0
};

/// At integration point `point` of a triangle with these nodes (m), whose sides may be curved. The area is negative where
/// the triangle is inverted.
ShapeAtPoint shape_at(const AtSixNodes<Vec<2>>& nodes, int point);

/// The position of an integration point, m.
Vec<2> position_of(const ShapeAtPoint& shape, const AtSixNodes<Vec<2>>& nodes);

/// Gives a shape of the plane what it has around an axis, at this position.
void turn_around_axis(ShapeAtPoint& shape, const Vec<2>& position);

}  // namespace berm::fem
