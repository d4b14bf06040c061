// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/placement.hpp"
#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/triangle_mesh.hpp"

namespace berm::bodies {

/// What a file of triangles contains, about its centre of mass and in its axes of inertia.
struct Solid {
  Contents contents;  ///< in the axes of the file, m
  Real width;         ///< m, along the file's x
  TriangleMesh mesh;
};

/// A body with the closed surface of a file, in space only.
struct TriangulatedSettings {
  static constexpr const char* word = "surface";

  std::string file;
  Real scale = 1;                                  ///< m, a unit of the file
  std::vector<Real> position = {}, rotation = {};  ///< m, where the file's origin lies; rad, about the fixed axes x, then y, then z
  std::shared_ptr<const Solid> solid = nullptr;    ///< once the file is read
};

/// Reads the file. Throws InputError where it cannot be read, or its triangles are no closed surface.
void read_solid(TriangulatedSettings& surface);

void describe(Describe& d, TriangulatedSettings& surface);
void check(Describe& d, const std::string& path, const TriangulatedSettings& surface, int dimension);
std::string name_of(const TriangulatedSettings& surface);
std::vector<ShapeSize> sizes_of(const TriangulatedSettings& surface);
Outline outline_of(const TriangulatedSettings& surface);

/// Sharp as its triangles are: particles half a width away from an edge feel it as an arc of that radius.
template <int dim>
struct Triangulated {
  using Settings = TriangulatedSettings;
  static constexpr bool bounded = true, has_corners = true, in_space_only = true;

  Vec<dim> center;   ///< of mass
  Matrix<dim> axes;  ///< of inertia
  std::shared_ptr<const Solid> solid;
};

template <int dim>
Triangulated<dim> make_shape(const TriangulatedSettings& s);
template <int dim>
Real lowest_level(const Triangulated<dim>& body, const Vec<dim>& up);
template <int dim>
SurfaceMesh<dim> surface_mesh(const Triangulated<dim>& body, const Vec<dim>& lower, const Vec<dim>& upper);

template <int dim>
SurfacePoint<dim> surface_at(const Triangulated<dim>& body, const Vec<dim>& x)
{
  if constexpr (dim == 3) {
    const SurfacePoint<3> at = body.solid->mesh.surface_at(body.axes.transpose() * (x - body.center));
    return {at.distance, body.axes * at.normal};
  } else {
    return {infinity, Vec<dim>::UnitY()};
  }
}
template <int dim>
Real width_of(const Triangulated<dim>& body)
{
  return dim == 3 ? body.solid->width : 0;
}
template <int dim>
Real reach_of(const Triangulated<dim>& body)
{
  return dim == 3 ? body.solid->mesh.reach() : 0;
}
template <int dim>
Vec<3> inertia_over_mass(const Triangulated<dim>& body)
{
  return dim == 3 ? body.solid->contents.inertia : Vec<3>(Vec<3>::Zero());
}

}  // namespace berm::bodies
