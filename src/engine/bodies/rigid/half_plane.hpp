// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rotation.hpp"
#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

#include <algorithm>

namespace berm::bodies {

/// The half-space on one side of a plane.
struct HalfPlaneSettings {
  static constexpr const char* word = "half_plane";

  std::vector<Real> point;   ///< m, on the surface
  std::vector<Real> normal;  ///< points out of the rigid body; any length
};

inline void describe(Describe& d, HalfPlaneSettings& plane)
{
  d.value("point", plane.point, {.meaning = "a point of the surface", .unit = "m", .required = true});
  d.value("normal", plane.normal, {.meaning = "direction out of the rigid body, of any length", .required = true});
}

inline void check(Describe& d, const std::string& path, const HalfPlaneSettings& plane, int dimension)
{
  check_entries(d, path + ".point", plane.point, dimension);
  check_entries(d, path + ".normal", plane.normal, dimension);
  d.check(std::any_of(plane.normal.begin(), plane.normal.end(), [](Real n) { return n != 0; }), path + ".normal", "must not be zero");
}

inline std::string name_of(const HalfPlaneSettings&)
{
  return "half-plane";
}
inline Outline outline_of(const HalfPlaneSettings& plane)
{
  return PlaneOutline{to_vec<2>(plane.point), to_vec<2>(plane.normal).normalized()};
}

template <int dim>
struct HalfPlane {
  using Settings = HalfPlaneSettings;
  static constexpr bool bounded = false, has_corners = false;

  Vec<dim> point, normal;
};

template <int dim>
HalfPlane<dim> make_shape(const HalfPlaneSettings& s)
{
  return {to_vec<dim>(s.point), to_vec<dim>(s.normal).normalized()};
}

template <int dim>
SurfacePoint<dim> surface_at(const HalfPlane<dim>& plane, const Vec<dim>& x)
{
  return {plane.normal.dot(x - plane.point), plane.normal};
}

template <int dim>
Vec<dim> center_of(const HalfPlane<dim>& plane)
{
  return plane.point;
}
template <int dim>
Real lowest_level(const HalfPlane<dim>& plane, const Vec<dim>& up)
{
  return up.dot(plane.point);
}
template <int dim>
Real width_of(const HalfPlane<dim>&)
{
  return 0;
}
template <int dim>
Real reach_of(const HalfPlane<dim>&)
{
  return 0;
}
template <int dim>
Vec<3> inertia_over_mass(const HalfPlane<dim>&)
{
  return Vec<3>::Zero();
}
template <int dim>
HalfPlane<dim> moved(HalfPlane<dim> plane, const Movement<dim>& m)
{
  plane.point += m.displacement;
  return plane;
}

/// The part of a flat convex piece whose coordinate d times `sign` is at most sign * level.
template <int dim>
std::vector<Vec<dim>> clipped(const std::vector<Vec<dim>>& piece, int d, Real sign, Real level)
{
  std::vector<Vec<dim>> kept;
  const std::size_t n = piece.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<dim>&a = piece[k], &b = piece[(k + 1) % n];
    const Real beyond_a = sign * (a[d] - level), beyond_b = sign * (b[d] - level);
    if (beyond_a <= 0) kept.push_back(a);
    const bool last_of_line = dim == 2 && k + 1 == n;
    if (!last_of_line && (beyond_a < 0) != (beyond_b < 0) && beyond_a != 0 && beyond_b != 0)
      kept.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
  }
  return kept;
}

/// The part of its line (polygon) inside the box from lower to upper: no cell where it misses the box.
template <int dim>
SurfaceMesh<dim> surface_mesh(const HalfPlane<dim>& plane, const Vec<dim>& lower, const Vec<dim>& upper)
{
  // A piece that is larger than the box wherever the plane passes through it, around the plane's point nearest to the box's centre.
  const Vec<dim> middle = (lower + upper) / 2;
  const Vec<dim> center = middle - plane.normal.dot(middle - plane.point) * plane.normal;
  const Real reach = (upper - lower).norm(), rounding = 1e-9 * reach;
  Vec<dim> a = Vec<dim>::Zero();
  SurfaceMesh<dim> s;
  std::vector<Vec<dim>>& piece = s.points;
  if constexpr (dim == 2) {
    a << plane.normal[1], -plane.normal[0];
    piece = {center - reach * a, center + reach * a};
  } else {
    int min = 0;
    plane.normal.cwiseAbs().minCoeff(&min);
    a[min] = 1;
    a = (a - plane.normal[min] * plane.normal).normalized();
    const Vec<dim> b = cross(plane.normal, a);
    piece = {center - reach * (a + b), center + reach * (a - b), center + reach * (a + b), center - reach * (a - b)};
  }
  for (int d = 0; d < dim; ++d) {
    piece = clipped<dim>(piece, d, 1, upper[d] + rounding);
    piece = clipped<dim>(piece, d, -1, lower[d] - rounding);
  }
  if (piece.size() < dim) return {};
  s.add_all_points(dim == 2 ? SurfaceMesh<dim>::Kind::line : SurfaceMesh<dim>::Kind::polygon);
  return s;
}

template <class Visit>
void visit_sides(const HalfPlane<2>& plane, const Vec<2>& x, const Visit& visit)
{
  const Vec<2> from = x - plane.point;
  const Real away = plane.normal.dot(from);
  visit(0, OnSide{plane.normal[1] * from[0] - plane.normal[0] * from[1], away, -infinity, infinity, x[0] - away * plane.normal[0],
                  plane.normal[1], plane.normal});
}

}  // namespace berm::bodies
