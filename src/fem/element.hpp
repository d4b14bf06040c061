// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/triangle.hpp"

namespace berm::fem {

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

}  // namespace berm::fem
