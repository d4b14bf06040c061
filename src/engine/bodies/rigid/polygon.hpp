// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

#include <memory>

namespace berm::bodies {

/// A polygon, convex or not; in space an infinite prism along z. Corners in order, clockwise or counter-clockwise.
struct PolygonSettings {
  static constexpr const char* word = "polygon";
  static constexpr bool endless = true;

  std::vector<Real> x, y;  ///< m
};

void describe(Describe& d, PolygonSettings& polygon);
void check(Describe& d, const std::string& path, const PolygonSettings& polygon, int dimension);

/// Whether at least three distinct corners make a polygon whose sides meet at its corners only.
bool is_simple(const PolygonSettings& polygon);

std::string name_of(const PolygonSettings& polygon);
Outline outline_of(const PolygonSettings& polygon);

template <int dim>
struct Polygon {
  using Settings = PolygonSettings;
  static constexpr bool bounded = true, has_corners = true;

  Vec<dim> center;  ///< centroid
  Matrix<dim> axes;
  std::shared_ptr<const std::vector<Vec<2>>> corners;  ///< counter-clockwise, seen from the centroid along the axes
};

template <int dim>
Polygon<dim> make_shape(const PolygonSettings& s);
template <int dim>
SurfacePoint<dim> surface_at(const Polygon<dim>& polygon, const Vec<dim>& x);
template <int dim>
Real lowest_level(const Polygon<dim>& polygon, const Vec<dim>& up);
template <int dim>
Real width_of(const Polygon<dim>& polygon);
template <int dim>
Real reach_of(const Polygon<dim>& polygon);
template <int dim>
Vec<3> inertia_over_mass(const Polygon<dim>& polygon);

template <int dim>
SurfaceMesh<dim> surface_mesh(const Polygon<dim>& polygon, const Vec<dim>& lower, const Vec<dim>& upper)
{
  std::vector<Vec<dim>> outline;
  for (const Vec<2>& corner : *polygon.corners) outline.push_back(polygon.center + polygon.axes.template leftCols<2>() * corner);
  return extruded(outline, lower, upper);
}

template <class Visit>
void visit_sides(const Polygon<2>& polygon, const Vec<2>& x, const Visit& visit)
{
  const Vec<2> local = polygon.axes.transpose() * (x - polygon.center);
  const std::vector<Vec<2>>& corners = *polygon.corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2> side = corners[(k + 1) % corners.size()] - corners[k], along = side.normalized(), from = local - corners[k];
    const Real away = along[1] * from[0] - along[0] * from[1];
    const Vec<2> outwards(along[1], -along[0]), foot = polygon.center + polygon.axes * (local - away * outwards);
    visit(static_cast<int>(k),
          OnSide{along.dot(from), away, 0, side.norm(), foot[0], polygon.axes.row(0).dot(along), polygon.axes * outwards});
  }
}

}  // namespace berm::bodies
