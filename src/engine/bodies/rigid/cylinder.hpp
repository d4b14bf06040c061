// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/placement.hpp"
#include "bodies/rigid/shape_checks.hpp"

namespace berm::bodies {

enum class CylinderEnds { flat, round };

/// A cylinder of finite length, in space only.
struct CylinderSettings {
  static constexpr const char* word = "cylinder";

  std::vector<Real> center, axis;  ///< m; direction, of any length
  Real diameter = 0, length = 0;   ///< m, from end to end
  CylinderEnds ends = CylinderEnds::flat;
  Real corner_radius = 0;  ///< m, of the edges of flat ends

  /// Whether it stands.
  bool round_from_above() const { return std::abs(to_vec<3>(axis).normalized()[1]) >= std::sqrt(0.5); }
};

void describe(Describe& d, CylinderSettings& cylinder);
void check(Describe& d, const std::string& path, const CylinderSettings& cylinder, int dimension);
std::vector<ShapeSize> sizes_of(const CylinderSettings& cylinder);
Outline outline_of(const CylinderSettings& cylinder);

/// All that is nearer than the radius of the edges to a smaller cylinder, the core; with round ends the core is a line.
template <int dim>
struct Cylinder {
  using Settings = CylinderSettings;
  static constexpr bool bounded = true, has_corners = true, in_space_only = true;

  Vec<dim> center;
  Matrix<dim> axes;                   ///< its own axis is the second column
  Real core_radius, core_half, edge;  ///< m: radius and half the length of the core, radius of the edges
  Vec<3> inertia;                     ///< over mass, m2
};

template <int dim>
Cylinder<dim> make_shape(const CylinderSettings& s);

template <int dim>
SurfacePoint<dim> surface_at(const Cylinder<dim>& cylinder, const Vec<dim>& x)
{
  const Vec<dim> local = cylinder.axes.transpose() * (x - cylinder.center);
  Vec<dim> radial = local, axial = Vec<dim>::Zero();
  radial[1] = 0;
  axial[1] = local[1] < 0 ? -1 : 1;
  const Real radius = radial.norm();
  radial = radius > 0 ? Vec<dim>(radial / radius) : Vec<dim>(Vec<dim>::UnitX());
  const Real out = radius - cylinder.core_radius, along = std::abs(local[1]) - cylinder.core_half;
  Real distance = std::max(out, along);
  Vec<dim> normal = out >= along ? radial : axial;
  if (out > 0 && along > 0) {
    distance = std::hypot(out, along);
    normal = (out * radial + along * axial) / distance;
  }
  return {distance - cylinder.edge, cylinder.axes * normal};
}

template <int dim>
Real lowest_level(const Cylinder<dim>& cylinder, const Vec<dim>& up)
{
  const Real along = std::abs(cylinder.axes.col(1).dot(up)), across = std::sqrt(std::max(Real(0), 1 - along * along));
  return up.dot(cylinder.center) - along * cylinder.core_half - across * cylinder.core_radius - cylinder.edge;
}
template <int dim>
Real width_of(const Cylinder<dim>& cylinder)
{
  return 2 * (cylinder.core_radius + cylinder.edge);
}
template <int dim>
Real reach_of(const Cylinder<dim>& cylinder)
{
  return std::hypot(cylinder.core_radius, cylinder.core_half) + cylinder.edge;
}
template <int dim>
Vec<3> inertia_over_mass(const Cylinder<dim>& cylinder)
{
  return cylinder.inertia;
}

/// Half the outline of a cylinder in its own axes (x the radius, y along it), counter-clockwise, the arcs of so many points each.
std::vector<Vec<2>> half_outline(Real core_radius, Real core_half, Real edge, int points_of_arc);

template <int dim>
SurfaceMesh<dim> surface_mesh(const Cylinder<dim>& cylinder, const Vec<dim>&, const Vec<dim>&)
{
  if constexpr (dim == 3)
    return revolved_surface(half_outline(cylinder.core_radius, cylinder.core_half, cylinder.edge, 9),
                            [&](const Vec<3>& x) { return Vec<3>(cylinder.center + cylinder.axes * x); });
  else
    return {};
}

}  // namespace berm::bodies
