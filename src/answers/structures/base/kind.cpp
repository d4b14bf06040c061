// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/kind.hpp"

#include "core/axes.hpp"
#include "problem/ground.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>

namespace berm::base {
namespace {

constexpr Real round_off = 1e-6;  // of D
constexpr Real straight = 0.05;   // of D/2: how far a corner of a cone may lie from its face
constexpr Real max_apex = 120 * degree;
constexpr Real slender = 2;     // height of a pile over its width, and of a skirt over its wall
constexpr Real buried = 1;      // of D: cover of a T-bar that begins in the soil
constexpr Real standing = 0.5;  // of D: depth of a body that stands in the bed

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

/// The side that a profile turns to its axis at a level between its corners.
struct InnerSide {
  Real radius;  ///< m
  bool upright;
};

/// Empty where the body is closed there.
std::optional<InnerSide> inner_side(const bodies::ProfileSettings& profile, Real level, Real tolerance)
{
  const std::size_t n = profile.x.size(), sides = is_ring(profile) ? n : n - 1;  // what lies on the axis is no side
  std::optional<InnerSide> inner;
  int cut = 0;
  for (std::size_t k = 0; k < sides; ++k) {
    const std::size_t next = (k + 1) % n;
    const Real below = profile.y[k] - level, above = profile.y[next] - level;
    if (below * above >= 0) continue;
    ++cut;
    const Real x = std::lerp(profile.x[k], profile.x[next], below / (below - above));
    if (!inner || x < inner->radius) inner = {x, std::abs(profile.x[next] - profile.x[k]) <= tolerance};
  }
  return cut % 2 == 0 ? inner : std::nullopt;
}

/// The bore is that of the lowest upright side; an opening less deep than twice its wall is none.
void take_bore(const bodies::ProfileSettings& profile, BodyProfile& p)
{
  const Real tolerance = round_off * p.width;
  std::vector<Real> levels = profile.y;
  std::sort(levels.begin(), levels.end());
  for (std::size_t k = 0; k + 1 < levels.size() && std::isinf(p.lid); ++k) {
    if (levels[k + 1] - levels[k] <= tolerance) continue;
    const std::optional<InnerSide> inner = inner_side(profile, (levels[k] + levels[k + 1]) / 2, tolerance);
    if (!inner || (p.bore > 0 && inner->radius < p.bore - tolerance))
      p.lid = levels[k] - levels.front();
    else if (p.bore == 0 && inner->upright)
      p.bore = inner->radius;
  }
  if (p.bore == 0 || p.lid < slender * p.wall()) p.bore = 0, p.lid = infinity;
}

BodyProfile profile_of(const bodies::ProfileSettings& profile, const std::vector<Vec<2>>& corners)
{
  BodyProfile p = profile_of(corners);
  if (is_ring(profile) && profile.position.empty() && profile.axis.empty()) p.left = -p.right, p.width = 2 * p.right;
  if (is_ring(profile)) p.conical = false;
  take_bore(profile, p);
  return p;
}

std::string of_disk(const settings::Case& c, const BodyProfile& disk)
{
  if (c.geometry == settings::Geometry::axisymmetric) return std::abs(disk.left + disk.right) <= round_off * disk.width ? "ball" : "pipe";
  if (c.geometry == settings::Geometry::space) return bodies::is_round_from_above(c.rigid[main_rigid(c)].second.shape) ? "ball" : "pipe";
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

bool is_skirt(const BodyProfile& body)
{
  return body.bore > 0 && std::min(body.lid, body.height) >= slender * body.wall();
}

}  // namespace

std::optional<BodyProfile> body_profile(const bodies::RigidShapeSettings& shape)
{
  const bodies::Outline outline = std::visit([](const auto& s) { return outline_of(s); }, shape);
  if (const auto* disk = std::get_if<bodies::DiskOutline>(&outline)) return profile_of(*disk);
  const auto* corners = std::get_if<bodies::CornersOutline>(&outline);
  if (corners == nullptr) return {};
  if (const auto* profile = std::get_if<bodies::ProfileSettings>(&shape)) return profile_of(*profile, corners->corners);
  return profile_of(corners->corners);
}

bool is_pushed_down(const settings::Case& c)
{
  const auto has_positive = [](const std::vector<Real>& column) {
    return std::any_of(column.begin(), column.end(), [](Real v) { return v > 0; });
  };
  return std::any_of(c.stage.begin(), c.stage.end(), [&](const settings::StageSettings& s) {
    return s.kind == settings::StageKind::push && (s.velocity.value_or(0) > 0 || s.force.value_or(0) > 0 || has_positive(s.loads.of("V")) ||
                                                   has_positive(s.loads.of("w")) || has_positive(s.loads.of("w_displacement")));
  });
}

bool goes_sideways(const settings::Case& c, const settings::StageSettings& stage)
{
  if (c.geometry != settings::Geometry::space) return false;
  if (stage.kind == settings::StageKind::drag) return true;
  if (stage.kind != settings::StageKind::drive) return false;
  const int up = axes_of<3>(bodies::to_vec<3>(c.gravity)).up;
  const settings::FreedomSettings* freedoms[3] = {&stage.drive.x, &stage.drive.y, &stage.drive.z};
  for (int d = 0; d < 3; ++d) {
    constexpr settings::LoadAlong axes[3] = {settings::LoadAlong::x, settings::LoadAlong::y, settings::LoadAlong::z};
    const bool by_column = stage.loads.drives(axes[d]);
    if (d != up && (by_column || freedoms[d]->velocity.value_or(0) != 0 || freedoms[d]->force.value_or(0) != 0)) return true;
  }
  return false;
}

bool is_loaded_sideways(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  if (rigid == none || c.geometry != settings::Geometry::space) return false;
  const bodies::RigidSettings& settings = c.rigid[rigid].second;
  const std::string& word = settings.structure;
  if (word != "automatic" && word != "pile" && word != "skirt") return false;
  const std::optional<BodyProfile> body = body_profile(settings.shape);
  if (!body || body->disk || !bodies::is_round_from_above(settings.shape) || !(reference_depth(c) > standing * body->width)) return false;
  return std::any_of(c.stage.begin(), c.stage.end(), [&](const settings::StageSettings& stage) { return goes_sideways(c, stage); });
}

std::string kind_of(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  if (rigid == none || !drives_a_body(c)) return "other";
  const bodies::RigidSettings& settings = c.rigid[rigid].second;
  if (settings.structure != "automatic") return settings.structure;
  const std::optional<BodyProfile> body = body_profile(settings.shape);
  if (!body) return "other";
  if (!is_pushed_down(c)) return !is_loaded_sideways(c) ? "pipe" : is_skirt(*body) ? "skirt" : "pile";
  if (body->disk) return of_disk(c, *body);
  if (const auto* cylinder = std::get_if<bodies::CylinderSettings>(&settings.shape)) return of_cylinder(*cylinder);
  const bool revolved = c.geometry == settings::Geometry::axisymmetric ||
                        (c.geometry == settings::Geometry::space && bodies::is_round_from_above(settings.shape));
  if (!revolved) return "footing";
  if (is_skirt(*body)) return "skirt";
  if (body->conical) return "cone";
  return body->height > slender * body->width ? "pile" : "footing";
}

}  // namespace berm::base
