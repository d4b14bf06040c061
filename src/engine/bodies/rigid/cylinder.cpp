// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_solid_test.cpp
#include "bodies/rigid/cylinder.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

Real edge_of(const CylinderSettings& s)
{
  return s.ends == CylinderEnds::round ? s.diameter / 2 : s.corner_radius;
}

}  // namespace

void describe(Describe& d, CylinderSettings& cylinder)
{
  d.value("center", cylinder.center, {.meaning = "middle of the cylinder", .unit = "m", .required = true});
  d.value("axis", cylinder.axis, {.meaning = "direction of its axis, of any length", .required = true});
  d.value("diameter", cylinder.diameter, {.meaning = "diameter of the cylinder", .unit = "m", .range = positive, .required = true});
  d.value("length", cylinder.length,
          {.meaning = "length from end to end, round ends included", .unit = "m", .range = positive, .required = true});
  d.choice("ends", cylinder.ends, {"flat", "round"}, {.meaning = "flat ends, or half spheres"});
  d.value("corner_radius", cylinder.corner_radius,
          {.meaning = "radius of the edges of flat ends; 0 = sharp, which acts on particles half a width away like an arc",
           .unit = "m",
           .range = not_negative});
}

void check(Describe& d, const std::string& path, const CylinderSettings& cylinder, int dimension)
{
  d.check(dimension == 3, path + ".shape", "a cylinder needs three dimensions; in plane strain use shape = \"circle\"");
  check_entries(d, path + ".center", cylinder.center, 3);
  check_entries(d, path + ".axis", cylinder.axis, 3);
  d.check(!to_vec<3>(cylinder.axis).isZero(0), path + ".axis", "must not be zero");
  const bool round = cylinder.ends == CylinderEnds::round;
  d.check(!round || cylinder.corner_radius == 0, path + ".corner_radius", "is for flat ends; round ones are half spheres");
  d.check(!round || cylinder.length >= cylinder.diameter, path + ".length", "with round ends must be the diameter or more");
  d.check(2 * cylinder.corner_radius <= std::min(cylinder.diameter, cylinder.length), path + ".corner_radius",
          "must be half the diameter and half the length at most");
}

std::vector<ShapeSize> sizes_of(const CylinderSettings& cylinder)
{
  return {{"diameter", cylinder.diameter}, {"length", cylinder.length}};
}
Outline outline_of(const CylinderSettings& s)
{
  const Cylinder<3> cylinder = make_shape<3>(s);
  return hull_of(seen_along_z(surface_mesh<3>(cylinder, Vec<3>::Zero(), Vec<3>::Zero()).points));
}

std::vector<Vec<2>> half_outline(Real core_radius, Real core_half, Real edge, int points_of_arc)
{
  std::vector<Vec<2>> outline{{0, -core_half - edge}};
  const auto corner = [&](Real level, Real first) {
    for (int p = 0; p < points_of_arc; ++p) {
      const Real angle = first + pi / 2 * p / (points_of_arc - 1);
      outline.emplace_back(core_radius + edge * std::cos(angle), level + edge * std::sin(angle));
      if (edge == 0) return;
    }
  };
  corner(-core_half, -pi / 2);
  corner(core_half, 0);
  outline.emplace_back(0, core_half + edge);
  if (core_radius == 0) {  // the arcs begin and end at the poles themselves
    outline.erase(outline.begin() + 1);
    outline.erase(outline.end() - 2);
  }
  return outline;
}

template <int dim>
Cylinder<dim> make_shape(const CylinderSettings& s)
{
  Cylinder<dim> cylinder{to_vec<dim>(s.center), Matrix<dim>::Identity(), s.diameter / 2 - edge_of(s), s.length / 2 - edge_of(s), edge_of(s),
                         Vec<3>::Zero()};
  if constexpr (dim == 3) {
    cylinder.axes = frame_along(to_vec<3>(s.axis));
    constexpr int fine = 1000;  // the chords miss 1e-7 of a round end's mass
    cylinder.inertia = revolved(half_outline(cylinder.core_radius, cylinder.core_half, cylinder.edge, fine)).inertia;
  }
  return cylinder;
}

template Cylinder<2> make_shape<2>(const CylinderSettings&);
template Cylinder<3> make_shape<3>(const CylinderSettings&);

}  // namespace berm::bodies
