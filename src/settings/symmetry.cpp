// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/symmetry_test.cpp
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

bool moves(const FreedomSettings& along)
{
  return along.velocity || along.force || along.hold || along.free || along.spring;
}
bool turns(const TurnSettings& about)
{
  return about.velocity || about.moment || about.free || about.spring;
}

void check_bodies_mirrored(Describe& d, const Case& c, int axis)
{
  const std::string across = fmt::format("must not cross the plane of symmetry: its {} must be 0", axis_names[axis]);
  const auto at = [&](const std::vector<Real>& v) { return v.size() > static_cast<std::size_t>(axis) ? v[axis] : Real(0); };
  for (const auto& [name, body] : c.body) {
    for (std::size_t k = 0; k < body.initial_velocity.size(); ++k)
      d.check(at(body.initial_velocity[k].amplitude) == 0, fmt::format("body.{}.initial_velocity[{}].amplitude", name, k), across);
    d.check(body.initial_angular_velocity == 0 || axis == 2, "body." + name + ".initial_angular_velocity",
            "a rotation about z is not its own mirror image across x: leave it out, or \"x\" out of symmetry");
  }
  for (const auto& [name, rigid] : c.rigid) {
    d.check(at(rigid.velocity) == 0, "rigid." + name + ".velocity", across);
    d.check(rigid.rotation == bodies::Rotation::fixed || c.symmetry.size() == 1, "rigid." + name + ".rotation",
            "a quarter that rotates is not its own mirror image across both planes: leave rotation out, or one axis out of symmetry");
  }
  for (const auto& [name, traction] : c.traction) d.check(at(traction.stress) == 0, "traction." + name + ".stress", across);
}

void check_stages_mirrored(Describe& d, const Case& c, int axis)
{
  const std::string name = axis_names[axis];
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const StageSettings& stage = c.stage[k];
    const std::string path = fmt::format("stage[{}]", k);
    d.check(axis != 0 || (stage.kind != StageKind::drag && stage.kind != StageKind::sweep), path + ".kind",
            "moves across the plane of symmetry: leave \"x\" out of symmetry, and model a half", {"geostatic", "push", "free", "drive"});
    const FreedomSettings* along[] = {&stage.drive.x, &stage.drive.y, &stage.drive.z};
    d.check(!moves(*along[axis]), path + ".drive." + name,
            fmt::format("moves across the plane of symmetry: leave it out, or \"{}\" out of symmetry", name));
    const std::pair<const char*, const TurnSettings*> about[] = {
        {"rotation_x", &stage.drive.rotation_x}, {"rotation_y", &stage.drive.rotation_y}, {"rotation_z", &stage.drive.rotation_z}};
    for (int other = 0; other < 3; ++other)
      d.check(other == axis || !turns(*about[other].second), path + ".drive." + about[other].first,
              fmt::format("only a rotation about {0} is its own mirror image across {0}: leave it out, or \"{0}\" out of symmetry", name));
  }
}

}  // namespace

bool mirrors(const Case& c, int axis)
{
  return std::find(c.symmetry.begin(), c.symmetry.end(), axis_names[axis]) != c.symmetry.end();
}

void check_symmetry(Describe& d, const Case& c)
{
  if (c.symmetry.empty()) return;
  d.check(c.geometry == Geometry::space, "symmetry", "planes of symmetry are for geometry = \"space\": leave symmetry out");
  for (const std::string& axis : c.symmetry) {
    d.check(axis == "x" || axis == "z", "symmetry", fmt::format("\"{}\" is not an axis with a plane of symmetry across it", axis),
            {"x", "z"});
    d.check(std::count(c.symmetry.begin(), c.symmetry.end(), axis) == 1, "symmetry", fmt::format("names \"{}\" twice", axis));
  }
  for (const int axis : {0, 2}) {
    if (!mirrors(c, axis)) continue;
    d.check(c.gravity.size() < 3 || c.gravity[axis] == 0, "gravity",
            fmt::format("is inclined to the plane of symmetry: its {0} must be 0, or leave \"{0}\" out of symmetry", axis_names[axis]));
    if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh); bed != nullptr && axis == 0)
      d.check(bed->slope == 0 && !bed->trench && !bed->step, "mesh",
              "a bed with a slope, a trench or a step is not its own mirror image across x: leave \"x\" out of symmetry");
    check_bodies_mirrored(d, c, axis);
    check_stages_mirrored(d, c, axis);
  }
}

Real parts_of(const Case& c)
{
  return c.geometry == Geometry::axisymmetric ? 2 * pi : std::pow(2, static_cast<int>(c.symmetry.size()));
}

Case part_of_whole(Case c)
{
  if (parts_of(c) == 1) return c;
  const Real fraction = 1 / parts_of(c);
  for (auto& entry : c.rigid) {
    entry.second.mass *= fraction;
    if (entry.second.moment_of_inertia) *entry.second.moment_of_inertia *= fraction;
  }
  for (StageSettings& stage : c.stage) {
    DriveSettings& drive = stage.drive;
    for (std::optional<Real>* of_whole :
         {&stage.force, &stage.vertical_force, &stage.until.force, &drive.x.force, &drive.y.force, &drive.z.force, &drive.rotation_x.moment,
          &drive.rotation_y.moment, &drive.rotation_z.moment, &drive.x.spring, &drive.y.spring, &drive.z.spring, &drive.rotation_x.spring,
          &drive.rotation_y.spring, &drive.rotation_z.spring})
      if (*of_whole) **of_whole *= fraction;
    for (std::size_t k = 0; k < load_columns.size(); ++k)
      if (load_columns[k].quantity == LoadQuantity::force)
        for (Real& load : stage.loads.columns[k]) load *= fraction;
  }
  return c;
}

}  // namespace berm::settings
