// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

#include <Eigen/LU>
#include <array>

namespace berm::fem {

/// Nodes of a quadratic element: the 6-node triangle; in space the 10-node tetrahedron.
template <int dim>
constexpr int element_nodes = (dim + 1) * (dim + 2) / 2;

/// A value for each node of an element: corners, in the plane counter-clockwise, then the middles of element_edges.
template <int dim, class T>
using AtElementNodes = std::array<T, element_nodes<dim>>;
template <class T>
using AtSixNodes = AtElementNodes<2, T>;

/// The corners at the ends of each edge, in the order of the mid-side nodes.
template <int dim>
constexpr std::array<std::array<int, 2>, dim*(dim + 1) / 2> element_edges{};
template <>
inline constexpr std::array<std::array<int, 2>, 3> element_edges<2>{{{0, 1}, {1, 2}, {2, 0}}};
template <>
inline constexpr std::array<std::array<int, 2>, 6> element_edges<3>{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Coordinates of the nodes in the reference triangle 0 <= r, s, r + s <= 1.
inline const AtSixNodes<Vec<2>> six_nodes{Vec<2>{0, 0}, Vec<2>{1, 0}, Vec<2>{0, 1}, Vec<2>{0.5, 0}, Vec<2>{0.5, 0.5}, Vec<2>{0, 0.5}};

/// Those of an element of any dimension.
template <int dim>
AtElementNodes<dim, Vec<dim>> element_node_places()
{
  AtElementNodes<dim, Vec<dim>> at;
  for (int k = 0; k <= dim; ++k) at[k] = k == 0 ? Vec<dim>(Vec<dim>::Zero()) : Vec<dim>(Vec<dim>::Unit(k - 1));
  for (int e = 0; const auto [j, k] : element_edges<dim>) at[dim + 1 + e++] = (at[j] + at[k]) / 2;
  return at;
}

/// The barycentric coordinates l of a point of the reference element: l_0 = 1 - r - s (in space less t), then the point's own.
template <int dim>
std::array<Real, dim + 1> barycentric(const Vec<dim>& at)
{
  std::array<Real, dim + 1> l{1};
  for (int d = 0; d < dim; ++d) l[0] -= l[d + 1] = at[d];
  return l;
}

/// The quadratic shape functions at (r, s) or (r, s, t): l_k (2 l_k - 1) for the corners, 4 l_j l_k for the mid-side nodes.
template <int dim>
AtElementNodes<dim, Real> shape_functions(const Vec<dim>& at)
{
  const std::array<Real, dim + 1> l = barycentric<dim>(at);
  AtElementNodes<dim, Real> n;
  for (int k = 0; k <= dim; ++k) n[k] = l[k] * (2 * l[k] - 1);
  for (int e = 0; const auto [j, k] : element_edges<dim>) n[dim + 1 + e++] = 4 * l[j] * l[k];
  return n;
}

/// Their derivatives with respect to (r, s) or (r, s, t).
template <int dim>
AtElementNodes<dim, Vec<dim>> shape_derivatives(const Vec<dim>& at)
{
  const std::array<Real, dim + 1> l = barycentric<dim>(at);
  std::array<Vec<dim>, dim + 1> slope;  // of l
  slope[0] = Vec<dim>::Constant(-1);
  for (int d = 0; d < dim; ++d) slope[d + 1] = Vec<dim>::Unit(d);
  AtElementNodes<dim, Vec<dim>> n;
  for (int k = 0; k <= dim; ++k) n[k] = (4 * l[k] - 1) * slope[k];
  for (int e = 0; const auto [j, k] : element_edges<dim>) n[dim + 1 + e++] = 4 * (l[j] * slope[k] + l[k] * slope[j]);
  return n;
}

/// The Jacobian: column d is dx/dr, dx/ds or dx/dt, m. Its determinant is the area per unit of (r, s), twice that of a triangle
/// with straight sides; in space six times the volume of the tetrahedron.
template <int dim>
Matrix<dim> jacobian(const AtElementNodes<dim, Vec<dim>>& x, const AtElementNodes<dim, Vec<dim>>& derivatives)
{
  Matrix<dim> sum = Matrix<dim>::Zero();
  // From corner 0, whose own derivatives the others balance: no digits are lost far from the origin.
  for (int k = 1; k < element_nodes<dim>; ++k) sum += (x[k] - x[0]) * derivatives[k].transpose();
  return sum;
}

inline Matrix<2> jacobian(const AtSixNodes<Vec<2>>& x, const Vec<2>& at)
{
  return jacobian<2>(x, shape_derivatives<2>(at));
}

/// Stiffness of an element: the lower triangle of its 12 x 12 entries, row by row.
using CellStiffness = std::array<Real, 78>;

/// Integration points of an element: three in the triangle, four in the tetrahedron, exact for polynomials of degree 2 where sides
/// are straight. With so few the element does not lock at constant volume.
template <int dim>
constexpr int element_points = dim + 1;
constexpr int triangle_points = element_points<2>;

/// The shape functions of an element at one integration point.
template <int dim>
struct ElementPoint {
  AtElementNodes<dim, Real> value;
  AtElementNodes<dim, Vec<dim>> gradient;  ///< 1/m
  Real area;                               ///< m2, share of the element; in space its volume, m3; around an axis m3, times the radius
  Real per_radius;                         ///< 1/m, 1/r around an axis; else 0
};
using ShapeAtPoint = ElementPoint<2>;

/// At integration point `point` of an element with these nodes (m), whose sides may be curved. The area is negative where
/// the element is inverted.
template <int dim>
ElementPoint<dim> shape_at(const AtElementNodes<dim, Vec<dim>>& nodes, int point);
inline ShapeAtPoint shape_at(const AtSixNodes<Vec<2>>& nodes, int point)
{
  return shape_at<2>(nodes, point);
}

/// The position of an integration point, m.
template <int dim>
Vec<dim> position_of(const ElementPoint<dim>& shape, const AtElementNodes<dim, Vec<dim>>& nodes)
{
  Vec<dim> x = Vec<dim>::Zero();
  for (int k = 0; k < element_nodes<dim>; ++k) x += shape.value[k] * nodes[k];
  return x;
}

/// Gives a shape of the plane what it has around an axis, at this position.
void turn_around_axis(ShapeAtPoint& shape, const Vec<2>& position);

}  // namespace berm::fem
