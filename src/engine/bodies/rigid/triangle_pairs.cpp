// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_overlaps_test.cpp
#include "bodies/rigid/triangle_pairs.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace berm::bodies {
namespace {

using OfCorners = std::array<Real, 3>;

/// A part of a line, m from some point of it.
struct Part {
  Real from = infinity, to = -infinity;

  void add(Real at) { from = std::min(from, at), to = std::max(to, at); }
};

/// How far two parts of a line overlap, at least: by how much one would have to move.
Real overlap_of(const Part& one, const Part& other)
{
  return std::min(one.to - other.from, other.to - one.from);
}

bool are(const OfCorners& distances, auto&& what)
{
  return std::all_of(distances.begin(), distances.end(), what);
}

/// m, of the corners of a facet from the plane of another.
OfCorners distances_of(const Facet& facet, const Facet& plane)
{
  OfCorners found;
  for (int k = 0; k < 3; ++k) found[k] = plane.normal.dot(facet.corners[k] - plane.corners[0]);
  return found;
}

/// Where a facet crosses a plane, as the part of a line along `along` from `start`. Distances up to `zero` are none.
Part chord_of(const Facet& facet, const OfCorners& distances, const Vec<3>& start, const Vec<3>& along, Real zero)
{
  Part part;
  OfCorners at;
  for (int k = 0; k < 3; ++k) at[k] = along.dot(facet.corners[k] - start);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Real here = distances[k], there = distances[next];
    if (std::abs(here) <= zero) part.add(at[k]);
    if ((here > zero && there < -zero) || (here < -zero && there > zero)) part.add(at[k] + (at[next] - at[k]) * here / (here - there));
  }
  return part;
}

/// How far two triangles would have to move in a plane to be apart, m: least of the directions across their edges. Negative: they are apart.
Real depth_in_plane(const Facet& one, const Facet& other, const Vec<3>& normal)
{
  Real depth = infinity;
  for (const Facet* facet : {&one, &other})
    for (int k = 0; k < 3; ++k) {
      const Vec<3> across = normal.cross(facet->corners[(k + 1) % 3] - facet->corners[k]);
      const Real length = across.norm();
      if (length == 0) continue;  // an edge along the normal is a point of the plane
      Part of_one, of_other;
      for (const Vec<3>& x : one.corners) of_one.add(across.dot(x - one.corners[0]) / length);
      for (const Vec<3>& x : other.corners) of_other.add(across.dot(x - one.corners[0]) / length);
      depth = std::min(depth, overlap_of(of_one, of_other));
    }
  return depth;
}

}  // namespace

Facet facet_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c)
{
  return {{a, b, c}, (b - a).cross(c - a).normalized()};
}

Intersection intersection_of(const Facet& one, const Facet& other, const std::array<Index, 3>& shared, Real tolerance)
{
  OfCorners of_one = distances_of(one, other), of_other = distances_of(other, one);
  int count = 0;
  for (int k = 0; k < 3; ++k)
    if (shared[k] != none) of_one[k] = of_other[shared[k]] = 0, ++count;
  for (const OfCorners& distances : {of_one, of_other})
    if (are(distances, [&](Real d) { return d > tolerance; }) || are(distances, [&](Real d) { return d < -tolerance; }))
      return Intersection::apart;

  const auto small = [&](Real d) { return std::abs(d) <= tolerance; };
  if (are(of_other, small)) return depth_in_plane(one, other, one.normal) > tolerance ? Intersection::overlap : Intersection::apart;
  if (are(of_one, small)) return depth_in_plane(one, other, other.normal) > tolerance ? Intersection::overlap : Intersection::apart;
  if (count == 2) return Intersection::apart;

  const Vec<3> along = one.normal.cross(other.normal).normalized(), &start = one.corners[0];
  const auto overlap = [&](Real zero) {
    return overlap_of(chord_of(one, of_one, start, along, zero), chord_of(other, of_other, start, along, zero));
  };
  if (overlap(tolerance) <= tolerance) return Intersection::apart;
  const auto is_divided = [&](const OfCorners& distances) {
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    return *least<-tolerance&& * most> tolerance;
  };
  return is_divided(of_one) && is_divided(of_other) && overlap(0) > tolerance ? Intersection::cut : Intersection::touch;
}

Hit hit_of(const Facet& facet, const Vec<3>& start, const Vec<3>& direction, Real tolerance)
{
  constexpr Real near = 1e-6;  // as a share of the triangle
  const Vec<3>& origin = facet.corners[0];
  const Vec<3> b = facet.corners[1] - origin, c = facet.corners[2] - origin, from = start - origin;
  const Real towards = direction.dot(facet.normal), distance = -from.dot(facet.normal);
  const bool flat = std::abs(towards) < near;
  const Vec<3> across = direction.cross(c);
  const Real determinant = b.dot(across);
  if (determinant == 0) return {.doubtful = flat};
  const Real u = from.dot(across) / determinant, v = direction.dot(from.cross(b)) / determinant, w = 1 - u - v;
  const Real least = std::min({u, v, w});
  if (least < -near && !flat) return {};
  const Real along = flat ? 0 : distance / towards;
  if (along < -tolerance && !flat) return {};
  if (flat || least < near || along < tolerance) return {.doubtful = true};
  return {.hit = true, .out = towards > 0};
}

}  // namespace berm::bodies
