// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/drawing_test.cpp
#include "report/setup/sketch.hpp"

#include "bodies/rigid/rigid_body.hpp"
#include "problem/drainage.hpp"
#include "report/setup/convex.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::report {
namespace {

Vec<2> in_plane(const std::vector<Real>& entries)
{
  return entries.size() < 2 ? Vec<2>(0, 0) : Vec<2>(entries[0], entries[1]);
}

Vec<2> middle_of(const Outline& outline)
{
  const Extent extent = extent_of(outline);
  return 0.5 * (extent.lower + extent.upper);
}

bool fills(const problem::Case& c, const std::string& region)
{
  return std::any_of(c.body.begin(), c.body.end(), [&](const auto& body) {
    const std::vector<std::string>& regions = body.second.regions;
    return std::find(regions.begin(), regions.end(), region) != regions.end();
  });
}

/// Of a bed that is not level.
void add_uneven(Sketch& sketch, const mesh::SeabedMesh& bed)
{
  const mesh::SeabedLayout at = layout_of(bed);
  const mesh::FineZone fine = fine_zone_of(bed);
  const auto point = [&](Real x, Real level) { return Vec<2>(x, level + std::tan(bed.slope) * x); };
  const auto part = [&](Real left, Real right, Real lower, Real upper) {
    return std::vector<Vec<2>>{point(left, lower), point(right, lower), point(right, upper), point(left, upper)};
  };
  const std::vector<Vec<2>> whole = part(at.left, at.right, -bed.depth, bed.headroom);
  std::vector<Vec<2>> soil = sketch.ground.line.corners;
  soil.insert(soil.end(), {whole[1], whole[0]});
  sketch.uneven = {soil, whole, part(fine.left, fine.right, fine.lower, fine.upper)};
  sketch.domain = extent_of(CornersOutline{whole});
  sketch.fine = extent_of(CornersOutline{sketch.uneven.back()});
  sketch.surface.reset();
  sketch.filled.clear();
}

void add_mesh(Sketch& sketch, const problem::Case& c, const mesh::SeabedMesh& bed)
{
  const mesh::SeabedLayout at = layout_of(bed);
  sketch.domain = {Vec<2>(at.left, -bed.depth), Vec<2>(at.right, bed.headroom)};
  sketch.domain_known = true;
  sketch.fine = Extent{Vec<2>(bed.near_left, -bed.near_depth), Vec<2>(bed.near_right, bed.near_height)};
  sketch.surface = c.surface;
  const Extent near{sketch.fine->lower, Vec<2>(bed.near_right, 0)};
  const Extent soil{Vec<2>(at.left + bed.layer, -bed.depth + bed.layer), Vec<2>(at.right - bed.layer, 0)};
  if (fills(c, "headroom")) sketch.filled.push_back({{Vec<2>(at.left, 0), sketch.domain.upper}, {}});
  if (bed.layer > 0 && fills(c, "layer")) sketch.filled.push_back({{sketch.domain.lower, Vec<2>(at.right, 0)}, soil});
  if (fills(c, "bed")) sketch.filled.push_back({soil, near});
  if (fills(c, "near")) sketch.filled.push_back({near, {}});
  if (!sketch.ground.line.level()) add_uneven(sketch, bed);
}

void add_mesh(Sketch& sketch, const problem::Case& c, const mesh::BoxMesh& box)
{
  sketch.domain.lower = in_plane(box.lower);
  sketch.domain.upper = sketch.domain.lower + in_plane(box.size);
  sketch.domain_known = true;
  if (fills(c, "box")) sketch.filled.push_back({sketch.domain, {}});
}

void add_mesh(Sketch& sketch, const problem::Case& c, const mesh::GmshFile& mesh)
{
  sketch.notes.push_back(fmt::format("The mesh comes from {}: its outline is not drawn.", mesh.file));
  for (const auto& [name, support] : c.support)
    sketch.notes.push_back(fmt::format("Held at its boundary \"{}\": {}.", support.boundary, fmt::join(support.fixed, ", ")));
}

void add_bodies(Sketch& sketch, const problem::Case& c)
{
  for (const auto& [name, body] : c.body) {
    if (body.block)
      sketch.bodies.push_back({name, outline_of(bodies::BoxSettings{body.block->center, body.block->size, body.block->angle})});
    if (body.disk) sketch.bodies.push_back({name, DiskOutline{in_plane(body.disk->center), body.disk->diameter / 2}});
    if (!body.regions.empty()) sketch.filled_by += (sketch.filled_by.empty() ? "" : ", ") + name;
    if (body.k0 && sketch.ground.line.level()) sketch.surface = c.surface;
    if (body.regions.empty()) {
      Vec<2> velocity = Vec<2>::Zero();
      for (const bodies::InitialVelocity& part : body.initial_velocity)
        if (part.wave_number.empty()) velocity += in_plane(part.amplitude);
      if (velocity.norm() > 0) sketch.flights.push_back({name, middle_of(sketch.bodies.back().outline), velocity});
    }
  }
  for (const auto& [name, rigid] : c.rigid) {
    const Outline outline = std::visit([](const auto& shape) { return outline_of(shape); }, rigid.shape);
    const auto* plane = std::get_if<PlaneOutline>(&outline);
    if (plane != nullptr && !(plane->normal.norm() > 0.5))
      sketch.notes.push_back(fmt::format("The rigid half-plane \"{}\" is parallel to the plane of the drawing.", name));
    sketch.rigid_bodies.push_back({name, outline});
  }
}

void take_domain_from_bodies(Sketch& sketch)
{
  std::optional<Extent> all;
  for (const std::vector<NamedOutline>* list : {&sketch.bodies, &sketch.rigid_bodies})
    for (const NamedOutline& body : *list) all = all ? around(*all, extent_of(body.outline)) : extent_of(body.outline);
  sketch.domain = all.value_or(Extent{Vec<2>::Zero(), Vec<2>::Zero()});
  const Real size = sketch.domain.size().maxCoeff();
  const Real rim = size > 0 ? 0.25 * size : 1;
  sketch.domain.lower -= Vec<2>(rim, rim);
  sketch.domain.upper += Vec<2>(rim, rim);
}

void add_supports(Sketch& sketch, const problem::Case& c)
{
  if (!sketch.domain_known) return;
  const Vec<2>&low = sketch.domain.lower, &high = sketch.domain.upper;
  std::array<Vec<2>, 4> corners = {low, Vec<2>(high[0], low[1]), high, Vec<2>(low[0], high[1])};
  if (!sketch.uneven.empty()) std::copy_n(sketch.uneven[1].begin(), 4, corners.begin());
  const std::vector<std::pair<std::vector<std::string>, HeldEdge>> edges = {
      {{"left"}, {corners[0], corners[3], Vec<2>(-1, 0), false, ""}},
      {{"right"}, {corners[1], corners[2], Vec<2>(1, 0), false, ""}},
      {{"base", "bottom"}, {corners[0], corners[1], Vec<2>(0, -1), false, ""}},
      {{"top"}, {corners[3], corners[2], Vec<2>(0, 1), false, ""}}};
  const bool water_flows = problem::has_flowing_water(c);
  for (const auto& [names, edge] : edges) {
    int held = 0, closed = 0;
    for (const auto& [name, support] : c.support)
      if (std::find(names.begin(), names.end(), support.boundary) != names.end())
        held |= fixed_directions(support), closed |= support.drained ? 0 : fixed_directions(support);
    if (held == 0) continue;
    std::vector<char> directions;
    for (int d = 0; d < 3; ++d)
      if ((held >> d & 1) != 0) directions.push_back(static_cast<char>('x' + d));
    const int across = edge.outward[0] != 0 ? 0 : 1;
    HeldEdge copy = edge;
    copy.wholly = (held & 3) == 3;
    copy.words = fmt::format("{} fixed{}", fmt::join(directions, ", "),
                             !water_flows                  ? ""
                             : (closed >> across & 1) != 0 ? ", no flow"
                                                           : ", drained");
    sketch.held.push_back(copy);
  }
  for (const auto& [name, support] : c.support)
    if (support.boundary == "back" || support.boundary == "front")
      sketch.notes.push_back(
          fmt::format("Held at the boundary \"{}\", parallel to the drawing: {}.", support.boundary, fmt::join(support.fixed, ", ")));
  if (!water_flows) return;
  std::string open = "Water leaves the soil at its free surface";
  for (const auto& [name, contact] : c.contact)
    if (contact.drained) open += fmt::format(" and through \"{}\"", contact.rigid);
  sketch.notes.push_back(open + ".");
}

/// How far a drive goes in its time: it grows evenly from nothing within the ramp.
std::optional<Real> travel_in_time(const problem::StageSettings& stage)
{
  if (!stage.velocity || !stage.until.time) return {};
  return std::abs(*stage.velocity) * std::max(0., *stage.until.time - stage.ramp / 2);
}

void add_path(Sketch& sketch, const problem::Case& c)
{
  std::vector<Vec<2>> centers;
  for (const NamedOutline& rigid : sketch.rigid_bodies) centers.push_back(middle_of(rigid.outline));
  for (int k = 0; k < static_cast<int>(c.stage.size()); ++k) {
    const problem::StageSettings& stage = c.stage[k];
    const bool push = stage.kind == problem::StageKind::push, drag = stage.kind == problem::StageKind::drag;
    if ((!push && !drag) || c.rigid.empty()) continue;
    const int rigid = static_cast<int>(stage.rigid.empty() ? 0 : problem::index_of(c.rigid, stage.rigid));
    const Extent extent = extent_of(sketch.rigid_bodies[rigid].outline);
    const Vec<2> from = centers[rigid];
    const Real reverse = stage.velocity.value_or(stage.force.value_or(1)) < 0 ? -1 : 1;
    const Real size = extent.size().maxCoeff(), whole = sketch.domain.size().maxCoeff();
    const Real nominal = size > 0 ? std::min(0.3 * size, 0.12 * whole) : 0.06 * whole;
    Vec<2> to = from;
    bool known = true;
    if (push && stage.until.embedment) {
      const Real lowest = from[1] - 0.5 * extent.size()[1];
      to[1] += sketch.ground.level_at(from[0], c.surface) - *stage.until.embedment - lowest;
    } else {
      const std::optional<Real> far = drag && stage.until.displacement ? stage.until.displacement : travel_in_time(stage);
      known = far.has_value();
      to[push ? 1 : 0] += (push ? -1 : 1) * reverse * far.value_or(nominal);
      if (drag && stage.vertical_velocity && stage.velocity && *stage.velocity != 0)
        to[1] -= *stage.vertical_velocity * std::abs((to[0] - from[0]) / *stage.velocity);
      else if (drag && stage.vertical == problem::Vertical::hold && !sketch.ground.line.level())
        to[1] += sketch.ground.line.height(to[0]) - sketch.ground.line.height(from[0]);
    }
    if ((to - from).norm() > 0) sketch.path.push_back({k, rigid, from, to, known});
    if (known) centers[rigid] = to;
  }
}

/// What the drawing, the plane x-y, does not show of a case in space.
std::string space_note(const problem::Case& c)
{
  std::string words = "The case is in space: drawn are the sides of its mesh and bodies in the plane x-y, y up";
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh); box != nullptr && box->size.size() == 3) {
    const Real from = box->lower.empty() ? 0 : box->lower[2];
    words += fmt::format("; along z, towards who looks, the mesh goes from {:.4g} m to {:.4g} m", from, from + box->size[2]);
  }
  return words + ".";
}

}  // namespace

Extent around(const Extent& a, const Extent& b)
{
  return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}

Extent extent_of(const Outline& outline)
{
  if (const auto* disk = std::get_if<DiskOutline>(&outline)) {
    const Vec<2> radius(disk->radius, disk->radius);
    return {disk->center - radius, disk->center + radius};
  }
  if (const auto* plane = std::get_if<PlaneOutline>(&outline)) return {plane->point, plane->point};
  const std::vector<Vec<2>>& corners = std::get<CornersOutline>(outline).corners;
  Extent extent{corners.front(), corners.front()};
  for (const Vec<2>& corner : corners) extent = around(extent, {corner, corner});
  return extent;
}

std::vector<Vec<2>> part_inside(const PlaneOutline& plane, const Extent& extent)
{
  const std::vector<Vec<2>> corners = {extent.lower, Vec<2>(extent.upper[0], extent.lower[1]), extent.upper,
                                       Vec<2>(extent.lower[0], extent.upper[1])};
  return cut(corners, [&](const Vec<2>& x) { return (plane.point - x).dot(plane.normal); });
}

Sketch sketch_of(const problem::Case& settings, const problem::Ground& ground)
{
  Sketch sketch;
  sketch.ground = ground;
  std::visit([&](const auto& mesh) { add_mesh(sketch, settings, mesh); }, settings.mesh);
  add_bodies(sketch, settings);
  if (!sketch.domain_known) take_domain_from_bodies(sketch);
  add_supports(sketch, settings);
  add_path(sketch, settings);
  sketch.gravity = in_plane(settings.gravity);
  if (settings.geometry == problem::Geometry::axisymmetric)
    sketch.notes.emplace_back("The case is axisymmetric: x is the radius, and the left edge is the axis.");
  if (settings.dimension() == 3) sketch.notes.push_back(space_note(settings));
  return sketch;
}

}  // namespace berm::report
