// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/rigid_surface.hpp"

#include <numeric>

namespace berm::run_folder {
namespace {

constexpr Index circle_points = 128;

std::vector<Index> count_up(Index count)
{
  std::vector<Index> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

/// The surface with this outline; in space it goes along z from lower to upper.
template <int dim>
RigidSurface<dim> along_z(const std::vector<Vec<dim>>& outline, const Vec<dim>& lower, const Vec<dim>& upper)
{
  RigidSurface<dim> s;
  const Index n = static_cast<Index>(outline.size());
  if constexpr (dim == 2) {
    s.points = outline;
    s.cells.push_back({io::VtkCell::polygon, count_up(n)});
  } else {
    for (Vec<dim> x : outline)
      for (const Real z : {lower[2], upper[2]}) {
        x[2] = z;
        s.points.push_back(x);
      }
    for (Index k = 0; k < n; ++k) {
      const Index a = 2 * k, b = 2 * ((k + 1) % n);
      s.cells.push_back({io::VtkCell::quad, {a, b, b + 1, a + 1}});
    }
  }
  return s;
}

template <int dim>
RigidSurface<dim> make(const bodies::Circle<dim>& circle, const Vec<dim>& lower, const Vec<dim>& upper)
{
  std::vector<Vec<dim>> outline;
  for (Index k = 0; k < circle_points; ++k) {
    const Real angle = circle.angle + 2 * pi * k / circle_points;
    Vec<dim> x = circle.center;
    x[0] += circle.radius * std::cos(angle);
    x[1] += circle.radius * std::sin(angle);
    outline.push_back(x);
  }
  RigidSurface<dim> s = along_z(outline, lower, upper);
  if (dim == 2 && circle.angle != 0) {  // a spoke shows the turn
    s.points.push_back(circle.center);
    s.cells.push_back({io::VtkCell::line, {circle_points, 0}});
  }
  return s;
}

template <int dim>
RigidSurface<dim> make(const bodies::Polygon<dim>& polygon, const Vec<dim>& lower, const Vec<dim>& upper)
{
  std::vector<Vec<dim>> outline;
  for (const Vec<2>& corner : *polygon.corners) outline.push_back(polygon.center + polygon.axes.template leftCols<2>() * corner);
  return along_z(outline, lower, upper);
}

template <int dim>
RigidSurface<dim> make(const bodies::Box<dim>& box, const Vec<dim>&, const Vec<dim>&)
{
  RigidSurface<dim> s;
  constexpr int corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  for (Index k = 0; k < (dim == 2 ? 4 : 8); ++k) {
    Vec<dim> local;
    for (int d = 0; d < dim; ++d) local[d] = corners[k][d] * box.half[d];
    s.points.push_back(box.center + box.axes * local);
  }
  s.cells.push_back({dim == 2 ? io::VtkCell::quad : io::VtkCell::hexahedron, count_up(static_cast<Index>(s.points.size()))});
  return s;
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

template <int dim>
RigidSurface<dim> make(const bodies::HalfPlane<dim>& plane, const Vec<dim>& lower, const Vec<dim>& upper)
{
  // A piece that is larger than the box wherever the plane passes through it, around the plane's point nearest to the box's centre.
  const Vec<dim> middle = (lower + upper) / 2;
  const Vec<dim> center = middle - plane.normal.dot(middle - plane.point) * plane.normal;
  const Real reach = (upper - lower).norm(), rounding = 1e-9 * reach;
  Vec<dim> a = Vec<dim>::Zero();
  std::vector<Vec<dim>> piece;
  if constexpr (dim == 2) {
    a << plane.normal[1], -plane.normal[0];
    piece = {center - reach * a, center + reach * a};
  } else {
    int min = 0;
    plane.normal.cwiseAbs().minCoeff(&min);
    a[min] = 1;
    a = (a - plane.normal[min] * plane.normal).normalized();
    const Vec<dim>& n = plane.normal;
    const Vec<dim> b(n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0]);
    piece = {center - reach * (a + b), center + reach * (a - b), center + reach * (a + b), center - reach * (a - b)};
  }
  for (int d = 0; d < dim; ++d) {
    piece = clipped<dim>(piece, d, 1, upper[d] + rounding);
    piece = clipped<dim>(piece, d, -1, lower[d] - rounding);
  }
  RigidSurface<dim> s;
  if (piece.size() < dim) return s;
  s.points = piece;
  s.cells.push_back({dim == 2 ? io::VtkCell::line : io::VtkCell::polygon, count_up(static_cast<Index>(piece.size()))});
  return s;
}

}  // namespace

template <int dim>
RigidSurface<dim> surface_of(const bodies::RigidShape<dim>& shape, const Vec<dim>& lower, const Vec<dim>& upper)
{
  return std::visit([&](const auto& s) { return make<dim>(s, lower, upper); }, shape);
}

template RigidSurface<2> surface_of<2>(const bodies::RigidShape<2>&, const Vec<2>&, const Vec<2>&);
template RigidSurface<3> surface_of<3>(const bodies::RigidShape<3>&, const Vec<3>&, const Vec<3>&);

}  // namespace berm::run_folder
