// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_test.cpp
#include "bodies/rigid/polygon.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

/// Twice the area of the triangle of the corners a, b and c, positive counter-clockwise.
Real twice_area(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c)
{
  return (p.x[b] - p.x[a]) * (p.y[c] - p.y[a]) - (p.y[b] - p.y[a]) * (p.x[c] - p.x[a]);
}

/// Whether corner c, in line with a and b, lies between them.
bool between(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c)
{
  return std::min(p.x[a], p.x[b]) <= p.x[c] && p.x[c] <= std::max(p.x[a], p.x[b]) && std::min(p.y[a], p.y[b]) <= p.y[c] &&
         p.y[c] <= std::max(p.y[a], p.y[b]);
}

/// Whether the lines from a to b and from c to d have a point in common.
bool meet(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c, std::size_t d)
{
  const Real of_c = twice_area(p, a, b, c), of_d = twice_area(p, a, b, d), of_a = twice_area(p, c, d, a), of_b = twice_area(p, c, d, b);
  if (((of_c > 0 && of_d < 0) || (of_c < 0 && of_d > 0)) && ((of_a > 0 && of_b < 0) || (of_a < 0 && of_b > 0))) return true;
  return (of_c == 0 && between(p, a, b, c)) || (of_d == 0 && between(p, a, b, d)) || (of_a == 0 && between(p, c, d, a)) ||
         (of_b == 0 && between(p, c, d, b));
}

Real cross(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Visits visit(a, b, cross(a, b)) for the ends of each side.
template <class Visit>
void visit_sides(const std::vector<Vec<2>>& corners, const Visit& visit)
{
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    visit(a, b, cross(a, b));
  }
}

}  // namespace

void describe(Describe& d, PolygonSettings& polygon)
{
  d.value("x", polygon.x, {.meaning = "x of the corners, one after the other, in either direction", .unit = "m", .required = true});
  d.value("y", polygon.y, {.meaning = "y of the corners", .unit = "m", .required = true});
}

void check(Describe& d, const std::string& path, const PolygonSettings& polygon, int)
{
  d.check(polygon.x.size() == polygon.y.size(), path + ".y",
          fmt::format("has {} numbers, and x has {}", polygon.y.size(), polygon.x.size()));
  d.check(polygon.x.size() >= 3, path + ".x", fmt::format("needs three corners or more, and has {}", polygon.x.size()));
  constexpr std::size_t max = 1000;  // every corner is compared with every other
  d.check(polygon.x.size() <= max, path + ".x", fmt::format("may have {} corners at most, and has {}", max, polygon.x.size()));
  const bool closed = !polygon.x.empty() && polygon.x.front() == polygon.x.back() && polygon.y.front() == polygon.y.back();
  d.check(!closed, path + ".x", "repeats the first corner at its end, as GIS and CAD close a ring: leave the last corner out, in x and y");
  d.check(is_simple(polygon), path + ".x", "the sides of a polygon must not cross or touch each other");
}

bool is_simple(const PolygonSettings& p)
{
  const std::size_t n = p.x.size();
  if (n < 3 || p.y.size() != n) return false;
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t b = (a + 1) % n, c = (a + 2) % n;
    if (p.x[a] == p.x[b] && p.y[a] == p.y[b]) return false;
    // A side may continue straight after a corner, but not turn back.
    if (twice_area(p, a, b, c) == 0 && (p.x[b] - p.x[a]) * (p.x[c] - p.x[b]) + (p.y[b] - p.y[a]) * (p.y[c] - p.y[b]) <= 0) return false;
    for (std::size_t other = a + 2; other < n; ++other)
      if ((other + 1) % n != a && meet(p, a, b, other, (other + 1) % n)) return false;
  }
  return true;
}

std::string name_of(const PolygonSettings& polygon)
{
  return fmt::format("polygon with {} corners", polygon.x.size());
}

Outline outline_of(const PolygonSettings& polygon)
{
  CornersOutline outline;
  for (std::size_t k = 0; k < polygon.x.size(); ++k) outline.corners.emplace_back(polygon.x[k], polygon.y[k]);
  return outline;
}

template <int dim>
Polygon<dim> make_shape(const PolygonSettings& s)
{
  // The sums are taken from the first corner, so that they lose no digits where the polygon is far from the origin.
  std::vector<Vec<2>> corners;
  for (std::size_t k = 0; k < s.x.size(); ++k) corners.emplace_back(s.x[k] - s.x[0], s.y[k] - s.y[0]);
  Real twice_area = 0;
  Vec<2> moment = Vec<2>::Zero();
  visit_sides(corners, [&](const Vec<2>& a, const Vec<2>& b, Real part) {
    twice_area += part;
    moment += part * (a + b) / 3;
  });
  const Vec<2> centroid = moment / twice_area;
  for (Vec<2>& corner : corners) corner -= centroid;
  if (twice_area < 0) std::reverse(corners.begin(), corners.end());
  Vec<dim> center = Vec<dim>::Zero();
  center[0] = s.x[0] + centroid[0];
  center[1] = s.y[0] + centroid[1];
  return {center, Matrix<dim>::Identity(), std::make_shared<const std::vector<Vec<2>>>(std::move(corners))};
}

template <int dim>
SurfacePoint<dim> surface_at(const Polygon<dim>& polygon, const Vec<dim>& x)
{
  const Vec<2> local = (polygon.axes.transpose() * (x - polygon.center)).template head<2>();
  const std::vector<Vec<2>>& corners = *polygon.corners;
  const std::size_t n = corners.size();
  Real min = infinity, distance = 0;
  Vec<2> normal = Vec<2>::Zero();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2>&a = corners[k], along = corners[(k + 1) % n] - a, reach = local - a;
    const Real t = std::clamp(reach.dot(along) / along.squaredNorm(), Real(0), Real(1));
    const Vec<2> from = reach - t * along;
    const Real square = from.squaredNorm();
    if (square >= min) continue;
    min = square;
    const Vec<2> outwards = Vec<2>(along[1], -along[0]).normalized();
    if ((t > 0 && t < 1) || square == 0) {
      distance = outwards.dot(reach);
      normal = outwards;
    } else {  // a point nearest to a corner is outside where the corner is convex, inside where it is re-entrant
      const Vec<2> before = t == 0 ? Vec<2>(a - corners[(k + n - 1) % n]) : along;
      const Vec<2> behind = t == 0 ? along : Vec<2>(corners[(k + 2) % n] - a - along);
      const Real sign = cross(before, behind) < 0 ? -1 : 1;
      distance = sign * std::sqrt(square);
      normal = from / distance;
    }
  }
  Vec<dim> in_space = Vec<dim>::Zero();
  in_space.template head<2>() = normal;
  return {distance, polygon.axes * in_space};
}

template <int dim>
Real lowest_level(const Polygon<dim>& polygon, const Vec<dim>& up)
{
  Real lowest = infinity;
  const Vec<dim> along = polygon.axes.transpose() * up;
  for (const Vec<2>& corner : *polygon.corners)
    lowest = std::min(lowest, up.dot(polygon.center) + along[0] * corner[0] + along[1] * corner[1]);
  return lowest;
}

template <int dim>
Real width_of(const Polygon<dim>& polygon)
{
  Real left = infinity, right = -infinity;
  for (const Vec<2>& corner : *polygon.corners) left = std::min(left, corner[0]), right = std::max(right, corner[0]);
  return right - left;
}

template <int dim>
Real reach_of(const Polygon<dim>& polygon)
{
  Real reach = 0;
  for (const Vec<2>& corner : *polygon.corners) reach = std::max(reach, corner.norm());
  return reach;
}

template <int dim>
Vec<3> inertia_over_mass(const Polygon<dim>& polygon)
{
  // The sum over the triangles between the centre and each side.
  Real second = 0, twice_area = 0;
  visit_sides(*polygon.corners, [&](const Vec<2>& a, const Vec<2>& b, Real part) {
    second += part * (a.dot(a) + a.dot(b) + b.dot(b));
    twice_area += part;
  });
  return {infinity, infinity, second / (6 * twice_area)};
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Polygon<dim> make_shape<dim>(const PolygonSettings&);                                                                           \
  template SurfacePoint<dim> surface_at<dim>(const Polygon<dim>&, const Vec<dim>&);                                                        \
  template Real lowest_level<dim>(const Polygon<dim>&, const Vec<dim>&);                                                                   \
  template Real width_of<dim>(const Polygon<dim>&);                                                                                        \
  template Real reach_of<dim>(const Polygon<dim>&);                                                                                        \
  template Vec<3> inertia_over_mass<dim>(const Polygon<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
