// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/triangle.hpp"

namespace berm::fem {

/// Points of numerical integration in a 6-node triangle: three, exact for polynomials of degree 2 on straight sides. With three points the
/// element does not lock at constant volume.
constexpr int triangle_points = 3;

/// The shape functions of a 6-node triangle at one point of integration.
struct ShapeAtPoint {
  AtSixNodes<Real> value;
  AtSixNodes<Vec<2>> gradient;  ///< 1/m
  Real area;                    ///< m2 that the point stands for
};

/// At point `point` of a triangle with these nodes (m), whose sides may be curved. The area is negative where the triangle is turned inside out.
ShapeAtPoint shape_at(const AtSixNodes<Vec<2>>& nodes, int point);

}  // namespace berm::fem
