// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape_checks.hpp"
#include "bodies/rigid/surface.hpp"

namespace berm::bodies {

/// A sphere, in space only.
struct SphereSettings {
  static constexpr const char* word = "sphere";
  static constexpr bool round = true, endless = false;

  std::vector<Real> center;  ///< m
  Real diameter = 0;         ///< m

  bool round_from_above() const { return true; }
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

template <int dim>
struct Sphere {
  using Settings = SphereSettings;
  static constexpr bool bounded = true, has_corners = false, in_space_only = true;

  Vec<dim> center;
  Real radius;
};

template <int dim>
Sphere<dim> make_shape(const SphereSettings& s)
{
  return {to_vec<dim>(s.center), s.diameter / 2};
}

template <int dim>
Vec<3> inertia_over_mass(const Sphere<dim>& sphere)
{
  return Vec<3>::Constant(0.4 * sphere.radius * sphere.radius);
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

}  // namespace berm::bodies
