// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

namespace berm::bodies {

/// A sphere, in space only.
struct SphereSettings {
  static constexpr const char* word = "sphere";

  std::vector<Real> center;  ///< m
  Real diameter = 0;         ///< m
};

inline void describe(Describe& d, SphereSettings& sphere)
{
  d.value("center", sphere.center, {.meaning = "centre of the sphere", .unit = "m", .required = true});
  d.value("diameter", sphere.diameter, {.meaning = "diameter of the sphere", .unit = "m", .range = positive, .required = true});
}

inline void check(Describe& d, const std::string& path, const SphereSettings& sphere, int dimension)
{
  d.check(dimension == 3, path + ".shape", "a sphere needs three dimensions; in plane strain use shape = \"circle\"");
  check_entries(d, path + ".center", sphere.center, dimension);
}

inline std::string name_of(const SphereSettings&)
{
  return "sphere";
}
inline std::vector<ShapeSize> sizes_of(const SphereSettings& sphere)
{
  return {{"diameter", sphere.diameter}};
}
inline Outline outline_of(const SphereSettings& sphere)
{
  return DiskOutline{to_vec<2>(sphere.center), sphere.diameter / 2};
}

template <int dim>
struct Sphere {
  using Settings = SphereSettings;
  static constexpr bool bounded = true, has_corners = false;

  Vec<dim> center;
  Real radius;
};

template <int dim>
Sphere<dim> make_shape(const SphereSettings& s)
{
  return {to_vec<dim>(s.center), s.diameter / 2};
}

template <int dim>
SurfacePoint<dim> surface_at(const Sphere<dim>& sphere, const Vec<dim>& x)
{
  const Vec<dim> from = x - sphere.center;
  const Real length = from.norm();
  if (length < 1e-12 * sphere.radius) return {-sphere.radius, Vec<dim>::UnitY()};
  return {length - sphere.radius, from / length};
}

template <int dim>
Vec<dim> center_of(const Sphere<dim>& sphere)
{
  return sphere.center;
}
template <int dim>
Real lowest_level(const Sphere<dim>& sphere, const Vec<dim>& up)
{
  return up.dot(sphere.center) - sphere.radius;
}
template <int dim>
Real width_of(const Sphere<dim>& sphere)
{
  return 2 * sphere.radius;
}
template <int dim>
Real reach_of(const Sphere<dim>& sphere)
{
  return sphere.radius;
}
template <int dim>
Vec<3> inertia_over_mass(const Sphere<dim>& sphere)
{
  return Vec<3>::Constant(0.4 * sphere.radius * sphere.radius);
}
template <int dim>
Sphere<dim> moved(Sphere<dim> sphere, const Movement<dim>& m)
{
  sphere.center += m.displacement;
  return sphere;
}

/// 32 meridians and 16 bands, of polygons: quads are reserved for the sides of extrusions along z.
template <int dim>
SurfaceMesh<dim> surface_mesh(const Sphere<dim>& sphere, const Vec<dim>&, const Vec<dim>&)
{
  constexpr Index meridians = 32, bands = 16;
  SurfaceMesh<dim> s;
  if constexpr (dim == 3) {
    for (Index b = 0; b <= bands; ++b)
      for (Index m = 0; m < meridians; ++m) {
        const Real polar = pi * b / bands, around = 2 * pi * m / meridians;
        const Vec<3> out(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around));
        s.points.push_back(sphere.center + sphere.radius * out);
      }
    for (Index b = 0; b < bands; ++b)
      for (Index m = 0; m < meridians; ++m) {
        const Index next = (m + 1) % meridians;
        s.add(SurfaceMesh<dim>::Kind::polygon,
              {b * meridians + m, b * meridians + next, (b + 1) * meridians + next, (b + 1) * meridians + m});
      }
  }
  return s;
}

/// Spheres exist in space only.
template <class Visit>
void visit_sides(const Sphere<2>&, const Vec<2>&, const Visit&)
{
}
inline Real closes_after(const Sphere<2>&)
{
  return infinity;
}

}  // namespace berm::bodies
