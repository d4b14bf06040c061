// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/kind.hpp"

#include "problem/ground.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>

namespace berm::base {
namespace {

constexpr Real round_off = 1e-6;  // of D
constexpr Real straight = 0.05;   // of D/2: how far a corner of a cone may lie from its face
constexpr Real max_apex = 120 * degree;
constexpr Real slender = 2;  // height of a pile over its width
constexpr Real buried = 1;   // of D: cover of a T-bar that begins in the soil

BodyProfile profile_of(const std::vector<Vec<2>>& corners)
{
  BodyProfile p;
  Real lowest = infinity, highest = -infinity;
  p.left = infinity, p.right = -infinity;
  for (const Vec<2>& x : corners) {
    p.left = std::min(p.left, x[0]), p.right = std::max(p.right, x[0]);
    lowest = std::min(lowest, x[1]), highest = std::max(highest, x[1]);
  }
  p.width = p.right - p.left;
  p.height = highest - lowest;
  p.shoulder = p.height;
  for (const Vec<2>& x : corners)
    if (x[0] >= p.right - round_off * p.width) p.shoulder = std::min(p.shoulder, x[1] - lowest);
  if (p.shoulder < round_off * p.width || p.apex_angle() > max_apex) return p;
  const Real middle = (p.left + p.right) / 2;
  p.conical = std::all_of(corners.begin(), corners.end(), [&](const Vec<2>& x) {
    const Real up = x[1] - lowest;
    return up >= p.shoulder || std::abs(std::abs(x[0] - middle) - p.width / 2 * up / p.shoulder) <= straight * p.width / 2;
  });
  return p;
}

BodyProfile profile_of(const bodies::DiskOutline& disk)
{
  const Real D = 2 * disk.radius;
  return {D, D, disk.radius, disk.center[0] - disk.radius, disk.center[0] + disk.radius, false, true};
}

/// Whether a stage pushes the body down.
bool is_pushed_down(const problem::Case& c)
{
  return std::any_of(c.stage.begin(), c.stage.end(), [](const problem::StageSettings& s) {
    return s.kind == problem::StageKind::push && (s.velocity.value_or(0) > 0 || s.force.value_or(0) > 0);
  });
}

std::string of_disk(const problem::Case& c, const BodyProfile& disk)
{
  if (c.geometry == problem::Geometry::axisymmetric) return std::abs(disk.left + disk.right) <= round_off * disk.width ? "ball" : "pipe";
  if (c.geometry == problem::Geometry::space) return bodies::is_round_from_above(c.rigid[main_rigid(c)].second.shape) ? "ball" : "pipe";
  const Real top = center_of<2>(make_shape<2>(c.rigid[main_rigid(c)].second.shape))[1] + disk.width / 2;
  const bool deep = problem::ground_of(c).line.level() && top < c.surface - buried * disk.width;
  return deep ? "t_bar" : "pipe";
}

/// Lying it is a pipe; standing, a pile or a footing.
std::string of_cylinder(const bodies::CylinderSettings& cylinder)
{
  if (!cylinder.round_from_above()) return "pipe";
  return cylinder.length > slender * cylinder.diameter ? "pile" : "footing";
}

}  // namespace

std::optional<BodyProfile> body_profile(const bodies::RigidShapeSettings& shape)
{
  const bodies::Outline outline = std::visit([](const auto& s) { return outline_of(s); }, shape);
  if (const auto* disk = std::get_if<bodies::DiskOutline>(&outline)) return profile_of(*disk);
  if (const auto* corners = std::get_if<bodies::CornersOutline>(&outline)) return profile_of(corners->corners);
  return {};
}

std::string kind_of(const problem::Case& c)
{
  const Index rigid = main_rigid(c);
  if (rigid == none || !drives_a_body(c)) return "other";
  const bodies::RigidSettings& settings = c.rigid[rigid].second;
  if (settings.structure != "automatic") return settings.structure;
  const std::optional<BodyProfile> body = body_profile(settings.shape);
  if (!body) return "other";
  if (!is_pushed_down(c)) return "pipe";
  if (body->disk) return of_disk(c, *body);
  if (const auto* cylinder = std::get_if<bodies::CylinderSettings>(&settings.shape)) return of_cylinder(*cylinder);
  const bool revolved = c.geometry == problem::Geometry::axisymmetric ||
                        (c.geometry == problem::Geometry::space && bodies::is_round_from_above(settings.shape));
  if (!revolved) return "footing";
  if (body->conical) return "cone";
  return body->height > slender * body->width ? "pile" : "footing";
}

}  // namespace berm::base
