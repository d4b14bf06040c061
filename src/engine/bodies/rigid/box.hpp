// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/placement.hpp"
#include "bodies/rigid/shape_checks.hpp"

namespace berm::bodies {

/// A rectangle (2D: may be rotated) or box; a plate is a thin one.
struct BoxSettings {
  static constexpr const char* word = "box";

  std::vector<Real> center, size;   ///< m
  Real angle = 0;                   ///< rad, counter-clockwise; 2D only
  std::vector<Real> rotation = {};  ///< rad, about the fixed axes x, then y, then z; in space only
  Real corner_radius = 0;           ///< m, in space only
};

void describe(Describe& d, BoxSettings& box);
void check(Describe& d, const std::string& path, const BoxSettings& box, int dimension);
std::vector<ShapeSize> sizes_of(const BoxSettings& box);
Outline outline_of(const BoxSettings& box);

/// In space all that is nearer than the radius of its edges to a smaller box, the core.
template <int dim>
struct Box {
  using Settings = BoxSettings;
  static constexpr bool bounded = true, has_corners = true;

  Vec<dim> center, half;  ///< half the sides of the core
  Matrix<dim> axes;       ///< columns: the directions of the sides
  Real edge = 0;          ///< m, radius of edges and corners; in the plane 0
};

template <int dim>
Box<dim> make_shape(const BoxSettings& s)
{
  Box<dim> box{to_vec<dim>(s.center), to_vec<dim>(s.size) / 2, turn<dim>(s.angle)};
  if constexpr (dim == 3) {
    box.axes = turned_about_axes(s.rotation);
    box.half -= Vec<3>::Constant(s.corner_radius);
    box.edge = s.corner_radius;
  }
  return box;
}

template <int dim>
SurfacePoint<dim> surface_at(const Box<dim>& box, const Vec<dim>& x)
{
  const Vec<dim> local = box.axes.transpose() * (x - box.center);
  const Vec<dim> beyond = local.cwiseAbs() - box.half;
  const Real edge = dim == 2 ? 0 : box.edge;
  Vec<dim> normal = Vec<dim>::Zero();
  int side = 0;
  const Real inside = beyond.maxCoeff(&side);
  if (inside <= 0) {
    normal[side] = local[side] < 0 ? -1 : 1;
    return {inside - edge, box.axes * normal};
  }
  const Vec<dim> outside = beyond.cwiseMax(0);
  const Real distance = outside.norm();
  for (int d = 0; d < dim; ++d) normal[d] = (local[d] < 0 ? -outside[d] : outside[d]) / distance;
  return {distance - edge, box.axes * normal};
}

template <int dim>
Real lowest_level(const Box<dim>& box, const Vec<dim>& up)
{
  return up.dot(box.center) - (box.axes.transpose() * up).cwiseAbs().dot(box.half) - box.edge;
}
template <int dim>
Real width_of(const Box<dim>& box)
{
  return 2 * (box.half[0] + box.edge);
}
template <int dim>
Real reach_of(const Box<dim>& box)
{
  return box.half.norm() + box.edge;
}
template <int dim>
Vec<3> inertia_over_mass(const Box<dim>& box);
template <int dim>
SurfaceMesh<dim> surface_mesh(const Box<dim>& box, const Vec<dim>& lower, const Vec<dim>& upper);

template <class Visit>
void visit_sides(const Box<2>& box, const Vec<2>& x, const Visit& visit)
{
  const Vec<2> local = box.axes.transpose() * (x - box.center);
  for (int side = 0; side < 4; ++side) {
    const int across = side / 2, along = 1 - across;
    const Real sign = side % 2 == 0 ? 1 : -1, away = sign * local[across] - box.half[across];
    visit(side, OnSide{local[along], away, -box.half[along], box.half[along], x[0] - away * sign * box.axes(0, across), box.axes(0, along),
                       sign * box.axes.col(across)});
  }
}

}  // namespace berm::bodies
