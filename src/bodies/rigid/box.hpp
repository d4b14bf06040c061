// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rotation.hpp"
#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

namespace berm::bodies {

/// A rectangle (2D: may be rotated) or box.
struct BoxSettings {
  static constexpr const char* word = "box";

  std::vector<Real> center, size;  ///< m
  Real angle = 0;                  ///< rad, counter-clockwise; 2D only
};

inline void describe(Describe& d, BoxSettings& box)
{
  d.value("center", box.center, {.meaning = "centre of the box", .unit = "m", .required = true});
  d.value("size", box.size, {.meaning = "lengths of its sides", .unit = "m", .range = positive, .required = true});
  d.value("angle", box.angle, {.meaning = "rotation of the box, counter-clockwise", .unit = "rad", .range = {-pi, pi}});
}

inline void check(Describe& d, const std::string& path, const BoxSettings& box, int dimension)
{
  check_entries(d, path + ".center", box.center, dimension);
  check_entries(d, path + ".size", box.size, dimension);
  d.check(dimension == 2 || box.angle == 0, path + ".angle", "a box can be rotated in two dimensions only");
}

inline std::string name_of(const BoxSettings&)
{
  return "box";
}
inline std::vector<ShapeSize> sizes_of(const BoxSettings& box)
{
  return {{"width", box.size[0]}, {"height", box.size[1]}};
}
inline Outline outline_of(const BoxSettings& box)
{
  const Vec<2> center = to_vec<2>(box.center), size = to_vec<2>(box.size);
  CornersOutline outline;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    outline.corners.emplace_back(center + turn<2>(box.angle) * Vec<2>(x * size[0], y * size[1]));
  return outline;
}

template <int dim>
struct Box {
  using Settings = BoxSettings;
  static constexpr bool bounded = true, has_corners = true;

  Vec<dim> center, half;
  Matrix<dim> axes;  ///< columns: the directions of the sides
};

template <int dim>
Box<dim> make_shape(const BoxSettings& s)
{
  return {to_vec<dim>(s.center), to_vec<dim>(s.size) / 2, turn<dim>(s.angle)};
}

template <int dim>
SurfacePoint<dim> surface_at(const Box<dim>& box, const Vec<dim>& x)
{
  const Vec<dim> local = box.axes.transpose() * (x - box.center);
  const Vec<dim> beyond = local.cwiseAbs() - box.half;
  Vec<dim> normal = Vec<dim>::Zero();
  int side = 0;
  const Real inside = beyond.maxCoeff(&side);
  if (inside <= 0) {
    normal[side] = local[side] < 0 ? -1 : 1;
    return {inside, box.axes * normal};
  }
  const Vec<dim> outside = beyond.cwiseMax(0);
  const Real distance = outside.norm();
  for (int d = 0; d < dim; ++d) normal[d] = (local[d] < 0 ? -outside[d] : outside[d]) / distance;
  return {distance, box.axes * normal};
}

template <int dim>
Vec<dim> center_of(const Box<dim>& box)
{
  return box.center;
}
template <int dim>
Real lowest_level(const Box<dim>& box, const Vec<dim>& up)
{
  return up.dot(box.center) - (box.axes.transpose() * up).cwiseAbs().dot(box.half);
}
template <int dim>
Real width_of(const Box<dim>& box)
{
  return 2 * box.half[0];
}
template <int dim>
Real reach_of(const Box<dim>& box)
{
  return box.half.norm();
}
template <int dim>
Vec<3> inertia_over_mass(const Box<dim>& box)
{
  Vec<3> inertia = Vec<3>::Constant(infinity);
  inertia[2] = box.half.template head<2>().squaredNorm() / 3;
  if constexpr (dim == 3)
    for (int d = 0; d < 2; ++d) inertia[d] = (box.half.squaredNorm() - box.half[d] * box.half[d]) / 3;
  return inertia;
}
template <int dim>
Box<dim> moved(Box<dim> box, const Movement<dim>& m)
{
  box.center += m.displacement;
  box.axes = m.rotation * box.axes;
  return box;
}

template <int dim>
SurfaceMesh<dim> surface_mesh(const Box<dim>& box, const Vec<dim>&, const Vec<dim>&)
{
  SurfaceMesh<dim> s;
  constexpr int corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  for (Index k = 0; k < (dim == 2 ? 4 : 8); ++k) {
    Vec<dim> local;
    for (int d = 0; d < dim; ++d) local[d] = corners[k][d] * box.half[d];
    s.points.push_back(box.center + box.axes * local);
  }
  s.add_all_points(dim == 2 ? SurfaceMesh<dim>::Kind::quad : SurfaceMesh<dim>::Kind::hexahedron);
  return s;
}

template <class Visit>
void visit_sides(const Box<2>& box, const Vec<2>& x, const Visit& visit)
{
  const Vec<2> local = box.axes.transpose() * (x - box.center);
  for (int side = 0; side < 4; ++side) {
    const int across = side / 2, along = 1 - across;
    const Real sign = side % 2 == 0 ? 1 : -1, away = sign * local[across] - box.half[across];
    visit(side,
          OnSide{local[along], away, -box.half[along], box.half[along], x[0] - away * sign * box.axes(0, across), box.axes(0, along)});
  }
}
inline Real closes_after(const Box<2>&)
{
  return infinity;
}

}  // namespace berm::bodies
