// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <numeric>
#include <string>
#include <variant>
#include <vector>

namespace berm::bodies {

/// Distance and normal of a rigid surface at a point.
template <int dim>
struct SurfacePoint {
  Real distance;    ///< m, negative inside the rigid body
  Vec<dim> normal;  ///< unit vector out of the rigid body
};

/// Coordinates of a point of the plane relative to a side of a surface.
struct OnSide {
  Real along;       ///< m along the side
  Real away;        ///< m from the side, negative inside the body
  Real begin, end;  ///< m, ends of the side
  Real x, x_slope;  ///< m, x of the point of the side nearest to it, and how that grows along the side
  Vec<2> normal;    ///< unit vector out of the body, of the side there
};

/// A surface as points and flat cells, for pictures.
template <int dim>
struct SurfaceMesh {
  enum class Kind { line, polygon, quad, hexahedron };
  struct Cell {
    Kind kind;
    std::vector<Index> points;
  };
  std::vector<Vec<dim>> points;  ///< m
  std::vector<Cell> cells;

  void add(Kind kind, std::vector<Index> corners) { cells.push_back({kind, std::move(corners)}); }
  void add_all_points(Kind kind)
  {
    std::vector<Index> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    add(kind, std::move(all));
  }
};

/// The surface with this outline; in space extruded along z from lower to upper.
template <int dim>
SurfaceMesh<dim> extruded(const std::vector<Vec<dim>>& outline, const Vec<dim>& lower, const Vec<dim>& upper)
{
  SurfaceMesh<dim> s;
  if constexpr (dim == 2) {
    s.points = outline;
    s.add_all_points(SurfaceMesh<dim>::Kind::polygon);
  } else {
    const Index n = static_cast<Index>(outline.size());
    for (Vec<dim> x : outline)
      for (const Real z : {lower[2], upper[2]}) {
        x[2] = z;
        s.points.push_back(x);
      }
    for (Index k = 0; k < n; ++k) {
      const Index a = 2 * k, b = 2 * ((k + 1) % n);
      s.add(SurfaceMesh<dim>::Kind::quad, {a, b, b + 1, a + 1});
    }
  }
  return s;
}

/// Outline of a rigid body in the plane x-y, before a mesh exists.
struct DiskOutline {
  Vec<2> center;
  Real radius;
};
struct CornersOutline {
  std::vector<Vec<2>> corners;
};
/// The line of a half-plane; the normal (a unit vector) points out of the body.
struct PlaneOutline {
  Vec<2> point, normal;
};
using Outline = std::variant<DiskOutline, CornersOutline, PlaneOutline>;

/// A named dimension of a shape, for tables.
struct ShapeSize {
  std::string name;
  Real size;  ///< m
};

/// The first dim numbers of a list; zero where it is shorter.
template <int dim>
Vec<dim> to_vec(const std::vector<Real>& numbers)
{
  Vec<dim> v = Vec<dim>::Zero();
  for (std::size_t d = 0; d < std::min<std::size_t>(dim, numbers.size()); ++d) v[d] = numbers[d];
  return v;
}

/// Motion of a shape since the start: displacement of its centre and rotation about it.
template <int dim>
struct Movement {
  Vec<dim> displacement;
  Matrix<dim> rotation;
  Real angle;  ///< in the plane, rad; in space 0
};

// What shapes have in common (shape.hpp says what it means). A shape that differs has a function of its own.

template <class Settings>
std::string name_of(const Settings&)
{
  return Settings::word;
}
template <class Settings>
std::vector<ShapeSize> sizes_of(const Settings&)
{
  return {};
}
template <int dim, class Shape>
requires requires(const Shape& shape)
{
  shape.center;
}
Vec<dim> center_of(const Shape& shape)
{
  return shape.center;
}
template <int dim, class Shape>
requires requires(const Shape& shape)
{
  shape.center;
}
Shape moved(Shape shape, const Movement<dim>& m)
{
  shape.center += m.displacement;
  if constexpr (requires { shape.axes; }) shape.axes = m.rotation * shape.axes;
  if constexpr (requires { shape.angle; }) shape.angle += m.angle;
  return shape;
}

// Of a circle and a sphere: all that is nearer than a radius to a centre, of a circle in space to a line along z.

template <class Settings>
requires(Settings::round) std::vector<ShapeSize> sizes_of(const Settings& round)
{
  return {{"diameter", round.diameter}};
}
template <class Settings>
requires(Settings::round) Outline outline_of(const Settings& round)
{
  return DiskOutline{to_vec<2>(round.center), round.diameter / 2};
}
template <int dim, class Shape>
requires(Shape::Settings::round) SurfacePoint<dim> surface_at(const Shape& round, const Vec<dim>& x)
{
  Vec<dim> from = x - round.center;
  if constexpr (dim == 3 && Shape::Settings::endless) from[2] = 0;
  const Real length = from.norm();
  if (length < 1e-12 * round.radius) return {-round.radius, Vec<dim>::UnitY()};
  return {length - round.radius, from / length};
}
template <int dim, class Shape>
requires(Shape::Settings::round) Real lowest_level(const Shape& round, const Vec<dim>& up)
{
  return up.dot(round.center) - round.radius;
}
template <int dim, class Shape>
requires(Shape::Settings::round) Real width_of(const Shape& round)
{
  return 2 * round.radius;
}
template <int dim, class Shape>
requires(Shape::Settings::round) Real reach_of(const Shape& round)
{
  return round.radius;
}

/// Visits the sides of a shape in the plane; those that exist in space only have none there.
template <class Shape, class Visit>
requires(Shape::in_space_only) void visit_sides(const Shape&, const Vec<2>&, const Visit&) {}
/// Length after which the first side repeats; infinite where it does not.
template <class Shape>
Real closes_after(const Shape&)
{
  return infinity;
}

}  // namespace berm::bodies
