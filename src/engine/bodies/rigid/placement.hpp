// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rotation.hpp"
#include "bodies/rigid/surface.hpp"

namespace berm::bodies {

/// The rotation that takes the y axis to this direction (any length) by the shortest way: the axes of a body around its own y. That to -y is half a turn about x.
Matrix<3> frame_along(const Vec<3>& axis);

/// Rotations about the fixed axes x, then y, then z (rad); none of them: the identity.
Matrix<3> turned_about_axes(const std::vector<Real>& angles);

/// The convex hull of points of the plane, counter-clockwise: the outline of a convex body seen along z.
CornersOutline hull_of(std::vector<Vec<2>> points);

/// Points seen along z.
template <class Points>
std::vector<Vec<2>> seen_along_z(const Points& points)
{
  std::vector<Vec<2>> seen;
  for (const Vec<3>& x : points) seen.emplace_back(x[0], x[1]);
  return seen;
}

/// A solid of revolution about y: volume (m3), level of its centre of mass (m) and moments of inertia per mass about it (m2), along x, y and z.
struct Revolution {
  Real volume, level;
  Vec<3> inertia;
};

/// That of the polygon with these corners (x >= 0 the radius, counter-clockwise): the integrals of x, x y, x^3 and x y^2 over it, as sums over its sides.
Revolution revolved(const std::vector<Vec<2>>& corners);

/// The surface that an outline (x >= 0 the radius, counter-clockwise, closed) makes around y, as polygons of 48 sectors; `place` takes a point of the body's own
/// axes to space. Sides on the axis make none.
template <class Place>
SurfaceMesh<3> revolved_surface(const std::vector<Vec<2>>& outline, const Place& place)
{
  constexpr Index sectors = 48;
  SurfaceMesh<3> s;
  const Index n = static_cast<Index>(outline.size());
  for (const Vec<2>& corner : outline)
    for (Index m = 0; m < sectors; ++m) {
      const Real around = 2 * pi * m / sectors;
      s.points.push_back(place(Vec<3>(corner[0] * std::sin(around), corner[1], corner[0] * std::cos(around))));
    }
  for (Index k = 0; k < n; ++k) {
    const Index next = (k + 1) % n;
    if (outline[k][0] == 0 && outline[next][0] == 0) continue;
    for (Index m = 0; m < sectors; ++m) {
      const Index beside = (m + 1) % sectors;
      if (outline[k][0] == 0)
        s.add(SurfaceMesh<3>::Kind::polygon, {k * sectors, next * sectors + beside, next * sectors + m});
      else if (outline[next][0] == 0)
        s.add(SurfaceMesh<3>::Kind::polygon, {k * sectors + m, k * sectors + beside, next * sectors});
      else
        s.add(SurfaceMesh<3>::Kind::polygon, {k * sectors + m, k * sectors + beside, next * sectors + beside, next * sectors + m});
    }
  }
  return s;
}

}  // namespace berm::bodies
