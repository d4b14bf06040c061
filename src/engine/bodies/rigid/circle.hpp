// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

namespace berm::bodies {

/// A circle; in space an infinite cylinder along z.
struct CircleSettings {
  static constexpr const char* word = "circle";
  static constexpr bool round = true, endless = true;

  std::vector<Real> center;  ///< m
  Real diameter = 0;         ///< m
};

inline void describe(Describe& d, CircleSettings& circle)
{
  d.value("center", circle.center, {.meaning = "centre of the circle", .unit = "m", .required = true});
  d.value("diameter", circle.diameter, {.meaning = "diameter D of the circle", .unit = "m", .range = positive, .required = true});
}

inline void check(Describe& d, const std::string& path, const CircleSettings& circle, int dimension)
{
  check_entries(d, path + ".center", circle.center, dimension);
}

template <int dim>
struct Circle {
  using Settings = CircleSettings;
  static constexpr bool bounded = true, has_corners = false;

  Vec<dim> center;
  Real radius;
  Real angle = 0;  ///< rad, of the radius drawn in pictures
};

template <int dim>
Circle<dim> make_shape(const CircleSettings& s)
{
  return {to_vec<dim>(s.center), s.diameter / 2};
}

template <int dim>
Vec<3> inertia_over_mass(const Circle<dim>& circle)
{
  return {infinity, infinity, circle.radius * circle.radius / 2};
}

template <int dim>
SurfaceMesh<dim> surface_mesh(const Circle<dim>& circle, const Vec<dim>& lower, const Vec<dim>& upper)
{
  constexpr Index count = 128;
  std::vector<Vec<dim>> outline;
  for (Index k = 0; k < count; ++k) {
    const Real angle = circle.angle + 2 * pi * k / count;
    Vec<dim> x = circle.center;
    x[0] += circle.radius * std::cos(angle);
    x[1] += circle.radius * std::sin(angle);
    outline.push_back(x);
  }
  SurfaceMesh<dim> s = extruded(outline, lower, upper);
  if (dim == 2 && circle.angle != 0) {  // a radius shows the rotation
    s.points.push_back(circle.center);
    s.add(SurfaceMesh<dim>::Kind::line, {count, 0});
  }
  return s;
}

/// One side of infinite length.
template <class Visit>
void visit_sides(const Circle<2>& circle, const Vec<2>& x, const Visit& visit)
{
  const Vec<2> from = x - circle.center;
  const Real angle = std::atan2(from[1], from[0]);
  visit(0, OnSide{circle.radius * angle, from.norm() - circle.radius, -infinity, infinity,
                  circle.center[0] + circle.radius * std::cos(angle), -std::sin(angle), Vec<2>(std::cos(angle), std::sin(angle))});
}
/// Length after which the first side repeats; infinite where it does not.
inline Real closes_after(const Circle<2>& circle)
{
  return 2 * pi * circle.radius;
}

}  // namespace berm::bodies
