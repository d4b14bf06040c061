// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_solid_test.cpp
#include "bodies/rigid/box.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

/// The integrals of 1 and of x_d^2 over a box with round edges: those over its sections across d, which are rectangles with round corners.
std::pair<Real, Real> volume_and_second(const Box<3>& box, int d)
{
  const Real a = box.half[d], b = box.half[(d + 1) % 3], c = box.half[(d + 2) % 3], r = box.edge;
  const Real of_core = 4 * b * c + 4 * r * (b + c) + pi * r * r;  // area of a section through the core
  // Beyond the core, at a + t, the section's corners have the radius s = sqrt(r^2 - t^2); integrals of s^k t^m over t from 0 to r.
  const Real s0 = pi * r * r / 4, s1 = r * r * r / 3, s2 = pi * r * r * r * r / 16;
  const Real q0 = 2 * r * r * r / 3, q1 = r * r * r * r / 4, q2 = 2 * r * r * r * r * r / 15;
  const Real volume = a * of_core + 4 * b * c * r + 4 * (b + c) * s0 + pi * q0;
  const Real beyond = 4 * b * c * (a * a * r + a * r * r + r * r * r / 3) + 4 * (b + c) * (a * a * s0 + 2 * a * s1 + s2) +
                      pi * (a * a * q0 + 2 * a * q1 + q2);
  return {2 * volume, 2 * (of_core * a * a * a / 3 + beyond)};
}

/// The surface of a box with round edges: the points of a sphere of their radius, each at the corner of the core that its direction is towards.
SurfaceMesh<3> rounded(const Box<3>& box)
{
  constexpr int arc = 5;
  constexpr Index around = 4 * arc, bands = 2 * arc;
  SurfaceMesh<3> s;
  for (Index k = 0; k < bands; ++k)
    for (Index m = 0; m < around; ++m) {
      const Real lift = pi / 2 * (k % arc) / (arc - 1) - (k < arc ? pi / 2 : 0), turned = pi / 2 * (m / arc + Real(m % arc) / (arc - 1));
      const Vec<3> out(std::cos(lift) * std::cos(turned), std::sin(lift), std::cos(lift) * std::sin(turned));
      const Vec<3> corner(m < arc || m >= 3 * arc ? 1 : -1, k < arc ? -1 : 1, m < 2 * arc ? 1 : -1);
      s.points.push_back(box.center + box.axes * (corner.cwiseProduct(box.half) + box.edge * out));
    }
  const auto at = [](Index k, Index m) { return k * around + m % around; };
  for (Index k = 0; k + 1 < bands; ++k)
    for (Index m = 0; m < around; ++m) s.add(SurfaceMesh<3>::Kind::polygon, {at(k, m), at(k + 1, m), at(k + 1, m + 1), at(k, m + 1)});
  s.add(SurfaceMesh<3>::Kind::polygon, {at(0, 0), at(0, arc), at(0, 2 * arc), at(0, 3 * arc)});
  s.add(SurfaceMesh<3>::Kind::polygon, {at(bands - 1, 3 * arc), at(bands - 1, 2 * arc), at(bands - 1, arc), at(bands - 1, 0)});
  return s;
}

}  // namespace

void describe(Describe& d, BoxSettings& box)
{
  d.value("center", box.center, {.meaning = "centre of the box", .unit = "m", .required = true});
  d.value("size", box.size, {.meaning = "lengths of its sides", .unit = "m", .range = positive, .required = true});
  d.value("angle", box.angle,
          {.meaning = "rotation of the box in the plane, counter-clockwise; in space see tilt", .unit = "rad", .range = {-pi, pi}});
  d.value("tilt", box.rotation,
          {.meaning = "in space: angles by which the box is rotated about the fixed axes x, then y, then z", .unit = "rad"});
  d.value("corner_radius", box.corner_radius,
          {.meaning = "in space: radius of its edges; 0 = sharp, which acts on particles half a width away like an arc",
           .unit = "m",
           .range = not_negative});
}

void check(Describe& d, const std::string& path, const BoxSettings& box, int dimension)
{
  check_entries(d, path + ".center", box.center, dimension);
  check_entries(d, path + ".size", box.size, dimension);
  d.check(dimension == 2 || box.angle == 0, path + ".angle", "is for the plane; in space a box has tilt = [about x, about y, about z]");
  d.check(dimension == 3 || box.rotation.empty(), path + ".tilt", "is for space; in the plane a box has an angle");
  if (dimension == 3) check_entries(d, path + ".tilt", box.rotation, 3, true);
  d.check(dimension == 3 || box.corner_radius == 0, path + ".corner_radius", "is for space; in the plane shape = \"profile\" has one");
  const Real least = box.size.empty() ? infinity : *std::min_element(box.size.begin(), box.size.end());
  d.check(2 * box.corner_radius <= least, path + ".corner_radius", "must be half the shortest side at most");
}

std::vector<ShapeSize> sizes_of(const BoxSettings& box)
{
  std::vector<ShapeSize> sizes{{"width", box.size[0]}, {"height", box.size[1]}};
  if (box.size.size() > 2) sizes.push_back({"depth", box.size[2]});
  return sizes;
}
Outline outline_of(const BoxSettings& box)
{
  if (box.size.size() > 2)
    return hull_of(seen_along_z(surface_mesh<3>(make_shape<3>(box), Vec<3>(Vec<3>::Zero()), Vec<3>(Vec<3>::Zero())).points));
  const Vec<2> center = to_vec<2>(box.center), size = to_vec<2>(box.size);
  CornersOutline outline;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    outline.corners.emplace_back(center + turn<2>(box.angle) * Vec<2>(x * size[0], y * size[1]));
  return outline;
}

template <int dim>
Vec<3> inertia_over_mass(const Box<dim>& box)
{
  Vec<3> inertia = Vec<3>::Constant(infinity);
  if constexpr (dim == 2) {
    inertia[2] = box.half.squaredNorm() / 3;
  } else {
    Vec<3> squares;
    for (int d = 0; d < 3; ++d) {
      const auto [volume, second] = volume_and_second(box, d);
      squares[d] = second / volume;
    }
    for (int d = 0; d < 3; ++d) inertia[d] = squares.sum() - squares[d];
  }
  return inertia;
}

template <int dim>
SurfaceMesh<dim> surface_mesh(const Box<dim>& box, const Vec<dim>&, const Vec<dim>&)
{
  if constexpr (dim == 3)
    if (box.edge > 0) return rounded(box);
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

template Vec<3> inertia_over_mass<2>(const Box<2>&);
template Vec<3> inertia_over_mass<3>(const Box<3>&);
template SurfaceMesh<2> surface_mesh<2>(const Box<2>&, const Vec<2>&, const Vec<2>&);
template SurfaceMesh<3> surface_mesh<3>(const Box<3>&, const Vec<3>&, const Vec<3>&);

}  // namespace berm::bodies
