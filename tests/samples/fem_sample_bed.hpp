// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/cut_mesh.hpp"
#include "fem/quadratic_mesh.hpp"
#include "material/linear_elastic.hpp"
#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

namespace berm {

/// A bed of 3 m x 1 m, -1.4 m < x < 1.6 m, of one elastic soil on rollers and a fixed base, with a rigid body of that shape.
inline settings::Case bed_around(const bodies::RigidShapeSettings& shape)
{
  settings::Case c;
  c.method = settings::Method::fem;
  c.mesh = mesh::SeabedMesh{.length = 3,
                            .depth = 1,
                            .headroom = 0.4,
                            .left = 1.4,
                            .near_size = 0.05,
                            .near_left = -0.35,
                            .near_right = 0.45,
                            .near_depth = 0.3,
                            .near_height = 0.1,
                            .growth = 0.2,
                            .far_size = 0.2,
                            .layer = 0.2};
  material::LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e6;
  c.material = {{"soft", law}};
  bodies::BodySettings soil;
  soil.material = "soft";
  soil.regions = {"near", "bed", "layer"};
  c.body = {{"soil", soil}};
  bodies::RigidSettings rigid;
  rigid.shape = shape;
  c.rigid = {{"pipe", rigid}};
  contact::ContactSettings skin;
  skin.body = "soil";
  skin.rigid = "pipe";
  c.contact = {{"skin", skin}};
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"base", {"base", {"x", "y"}}}, {"top", {"top", {"y"}}}};
  c.fem.contact_size = 0.02;
  return c;
}

/// Fills each region of the bed with a body of its own.
inline void fill_regions_apart(settings::Case& c)
{
  c.body[0].second.regions = {"bed"};
  for (const char* region : {"near", "layer"}) {
    c.body.push_back({region, c.body[0].second});
    c.body.back().second.regions = {region};
  }
}

/// A pipe of 0.4 m whose lowest point is at this depth.
inline bodies::CircleSettings pipe_at(Real embedment)
{
  return {{0.03, 0.2 - embedment}, 0.4};
}

inline std::vector<bodies::RigidShape<2>> shapes_of(const settings::Case& c)
{
  std::vector<bodies::RigidShape<2>> shapes;
  for (const auto& entry : c.rigid) shapes.push_back(make_shape<2>(entry.second.shape));
  return shapes;
}

inline mesh::Mesh<2> cut_mesh_of(const settings::Case& c)
{
  const TemporaryFolder folder;
  return fem::make_cut_mesh(c, ".", folder.path());
}

inline fem::QuadraticMesh quadratic_mesh_of(const settings::Case& c)
{
  return fem::make_quadratic(cut_mesh_of(c), c, shapes_of(c));
}

/// What an InputError says, or nothing.
template <class Make>
std::string refusal_of(const Make& make)
{
  try {
    make();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The determinant of the Jacobian is quadratic in (r, s); the middles of the sides, each with a third of the weight, integrate it exactly.
inline Real area_of(const fem::QuadraticMesh& mesh)
{
  Real area = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int k = 3; k < 6; ++k) area += fem::jacobian(mesh.positions_of(cell), fem::six_nodes[k]).determinant() / 6;
  return area;
}

/// The length of a curved side, by Gauss' rule with three points: far more exact than the parabola is.
inline Real length_of(const fem::QuadraticMesh& mesh, const fem::BoundarySide& side)
{
  const Vec<2>&a = mesh.position[side.from], &b = mesh.position[side.to], &m = mesh.position[side.middle];
  const auto speed = [&](Real t) { return Vec<2>((2 * t - 1) / 2 * a + (2 * t + 1) / 2 * b - 2 * t * m).norm(); };  // -1 < t < 1
  return (5 * speed(-std::sqrt(0.6)) + 8 * speed(0) + 5 * speed(std::sqrt(0.6))) / 9;
}

inline Real length_of(const fem::QuadraticMesh& mesh, const std::vector<fem::BoundarySide>& sides)
{
  Real length = 0;
  for (const fem::BoundarySide& side : sides) length += length_of(mesh, side);
  return length;
}

}  // namespace berm
