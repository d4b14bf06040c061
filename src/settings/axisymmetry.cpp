// SPDX-License-Identifier: BSD-3-Clause
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

constexpr Real round_off = 1e-9;

bool fits_axis(const bodies::DiskOutline& disk)
{
  return std::abs(disk.center[0]) <= round_off * disk.radius || disk.center[0] >= disk.radius;
}
bool fits_axis(const bodies::CornersOutline& outline)
{
  Real reach = 0, left = infinity;
  for (const Vec<2>& corner : outline.corners) reach = std::max(reach, corner.cwiseAbs().maxCoeff()), left = std::min(left, corner[0]);
  const auto has_image = [&](const Vec<2>& corner) {
    return std::any_of(outline.corners.begin(), outline.corners.end(),
                       [&](const Vec<2>& other) { return (other - Vec<2>(-corner[0], corner[1])).norm() <= round_off * reach; });
  };
  return left > 0 || std::all_of(outline.corners.begin(), outline.corners.end(), has_image);
}
bool fits_axis(const bodies::PlaneOutline& plane)
{
  return plane.normal[0] == 0 || plane.normal[1] == 0;
}

/// Whether a shape is a wall around the axis, which may widen.
bool is_wall(const bodies::RigidShapeSettings& shape)
{
  const auto* plane = std::get_if<bodies::HalfPlaneSettings>(&shape);
  return plane != nullptr && plane->normal.size() == 2 && plane->normal[1] == 0;
}

void check_bed(Describe& d, const mesh::SeabedMesh& bed)
{
  d.check(bed.left.has_value() && *bed.left == 0, "mesh", "around an axis the bed begins at it: it needs left = 0");
  d.check(bed.slope == 0 && !bed.trench && !bed.step, "mesh", "around an axis the bed is level, without slope, trench and step");
}

void check_soil_and_bodies(Describe& d, const Case& c)
{
  for (const auto& [name, body] : c.body) {
    d.check(body.initial_angular_velocity == 0, "body." + name + ".initial_angular_velocity", "is not axisymmetric");
    if (body.block)
      d.check(body.block->center.size() < 2 || body.block->size.size() < 2 || body.block->angle != 0 ||
                  body.block->center[0] - body.block->size[0] / 2 >= -round_off * body.block->size[0],
              "body." + name + ".block.center", "x is the radius: soil cannot be at x < 0");
  }
  for (const auto& [name, rigid] : c.rigid) {
    const std::string path = "rigid." + name;
    const bool fits = std::visit([](const auto& outline) { return fits_axis(outline); },
                                 std::visit([](const auto& shape) { return bodies::Outline(outline_of(shape)); }, rigid.shape));
    d.check(
        fits, path,
        "the body must be its own mirror image about the axis x = 0, or lie right of it: a circle or a box with its centre at x = 0, or "
        "shape = \"profile\"");
    d.check(rigid.rotation == bodies::Rotation::fixed, path + ".rotation", "a body around the axis does not rotate");
  }
}

void check_motion(Describe& d, const Case& c)
{
  for (const auto& [name, rigid] : c.rigid)
    d.check(rigid.velocity.empty() || rigid.velocity[0] == 0, "rigid." + name + ".velocity",
            "a body around the axis moves along it only: [0, ...]");
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const StageSettings& stage = c.stage[k];
    const std::string path = fmt::format("stage[{}]", k);
    d.check(stage.kind != StageKind::drag && stage.kind != StageKind::sweep, path + ".kind",
            "a body around the axis moves along it only: use \"push\", or \"drive\" along y", {"geostatic", "push", "free", "drive"});
    const FreedomSettings& x = stage.drive.x;
    const Index driven = stage.rigid.empty() ? 0 : index_of(c.rigid, stage.rigid);
    d.check((!x.velocity && !x.force && !x.hold && !x.free && !x.spring) || driven == none || c.rigid.empty() ||
                is_wall(c.rigid[driven].second.shape),
            path + ".drive.x",
            "is a degree of freedom around an axis for a wall only, a half_plane with its normal along x; for other bodies y is");
    const TurnSettings& turn = stage.drive.rotation;
    d.check(!turn.velocity && !turn.moment && !turn.fixed && !turn.free && !turn.spring, path + ".drive.rotation",
            "is not a degree of freedom around an axis: y is");
  }
}

}  // namespace

void check_axisymmetry(Describe& d, const Case& c)
{
  if (c.geometry != Geometry::axisymmetric) return;
  d.check(c.gravity.empty() || c.gravity[0] == 0, "gravity", "around an axis x = 0 gravity is along it: [0, ...]");
  d.check(c.initial_state != InitialState::gravity_loading, "initial_state", "around an axis the ground is level: use \"level_ground\"",
          {"automatic", "level_ground"});
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) check_bed(d, *bed);
  check_soil_and_bodies(d, c);
  check_motion(d, c);
}

}  // namespace berm::settings
