// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/box.hpp"
#include "bodies/rigid/circle.hpp"
#include "bodies/rigid/cylinder.hpp"
#include "bodies/rigid/half_plane.hpp"
#include "bodies/rigid/polygon.hpp"
#include "bodies/rigid/profile.hpp"
#include "bodies/rigid/sphere.hpp"
#include "bodies/rigid/triangulated.hpp"

namespace berm::bodies {

template <template <int> class... Shapes>
struct ShapeList {
  using Settings = std::variant<typename Shapes<2>::Settings...>;
  template <int dim>
  using In = std::variant<Shapes<dim>...>;
};

/// The closed list of shapes, one file each: settings with their declaration, checks, name and drawing; the exact surface
/// with distance and normal, lowest level, width, reach, moments of inertia, moved copy, surface mesh and, in the plane,
/// sides. A new shape is such a file and its word here.
using Shapes = ShapeList<Circle, HalfPlane, Box, Polygon, Profile, Sphere, Cylinder, Triangulated>;
using RigidShapeSettings = Shapes::Settings;
template <int dim>
using RigidShape = Shapes::In<dim>;

void describe_shape(Describe& d, RigidShapeSettings& shape);

/// Whether in space it is endless along z; whether there it is round seen from above: a sphere, a profile, a cylinder that stands.
bool is_endless(const RigidShapeSettings& shape);
bool is_round_from_above(const RigidShapeSettings& shape);

/// The circle across z of an endless body that is round, as a pipe is; empty for all others.
std::optional<DiskOutline> pipe_section(const RigidShapeSettings& shape);

template <int dim>
RigidShape<dim> make_shape(const RigidShapeSettings& settings);

/// The nearest point of the exact surface, for any point of space.
template <int dim>
SurfacePoint<dim> surface_at(const RigidShape<dim>& shape, const Vec<dim>& x);

/// Level of its lowest point along the unit vector up, m (of a half-plane: of its point).
template <int dim>
Real lowest_level(const RigidShape<dim>& shape, const Vec<dim>& up);

/// Its centre (of a half-plane: its point).
template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape);

/// Reference length of normalised results: diameter of a circle, sphere, cylinder or profile, width of a box or polygon, 0 for a half-plane.
template <int dim>
Real width_of(const RigidShape<dim>& shape);

/// Largest distance of its surface from its centre, m (in space, of an infinite prism: across it); 0 for a half-plane, which
/// never rotates.
template <int dim>
Real reach_of(const RigidShape<dim>& shape);

/// Moments of inertia per mass of a solid of this shape about its centre and its axes, m2; in the plane the last one
/// applies. Infinite about axes across an infinite length; 0 for a half-plane.
template <int dim>
Vec<3> inertia_over_mass(const RigidShape<dim>& shape);

/// The directions of these axes, as columns.
template <int dim>
Matrix<dim> axes_of(const RigidShape<dim>& shape)
{
  return std::visit(
      [](const auto& s) -> Matrix<dim> {
        if constexpr (requires { s.axes; })
          return s.axes;
        else
          return Matrix<dim>::Identity();
      },
      shape);
}

/// Its surface for pictures. A circle becomes a polygon of 128 points (in space: 128 quads along z from lower to upper) and, where it has turned, a line
/// from its centre; a box a quad (hexahedron, with round edges polygons); a solid of revolution polygons; a half-plane the part of its line (polygon) in the box from lower to upper: no cell where it misses that.
template <int dim>
SurfaceMesh<dim> surface_mesh(const RigidShape<dim>& shape, const Vec<dim>& lower, const Vec<dim>& upper)
{
  return std::visit([&](const auto& s) { return surface_mesh<dim>(s, lower, upper); }, shape);
}

/// Whether it is bounded in the plane; whether its surface has corners.
template <int dim>
bool is_bounded(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return s.bounded; }, shape);
}
template <int dim>
bool has_corners(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return s.has_corners; }, shape);
}

}  // namespace berm::bodies
