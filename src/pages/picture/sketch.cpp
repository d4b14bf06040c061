// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/model_picture_page_test.cpp
#include "picture/sketch.hpp"

#include "os/text_of_list.hpp"
#include "picture/stage_words.hpp"
#include "settings/drainage.hpp"
#include "structures/base/soil_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
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

void add_mesh(Sketch& sketch, const settings::Case& c, const mesh::SeabedMesh& bed)
{
  const mesh::SeabedLayout at = layout_of(bed);
  const auto part = [&](Real left, Real right, Real lower, Real upper) {
    Points corners = corners_of({Vec<2>(left, lower), Vec<2>(right, upper)});
    for (Vec<2>& corner : corners) corner[1] += std::tan(bed.slope) * corner[0];
    return corners;
  };
  const mesh::FineZone fine = fine_zone_of(bed);
  sketch.outline = part(at.left, at.right, -bed.depth, bed.headroom);
  sketch.fine = part(fine.left, fine.right, fine.lower, fine.upper);
  if (sketch.ground.line.level()) sketch.surface = c.surface;
}

void add_mesh(Sketch& sketch, const settings::Case& /*c*/, const mesh::BoxMesh& box)
{
  const Vec<2> lower = in_plane(box.lower);
  sketch.outline = corners_of({lower, lower + in_plane(box.size)});
}

void add_mesh(Sketch& sketch, const settings::Case& c, const mesh::GmshFile& mesh)
{
  sketch.notes.push_back(fmt::format("The mesh comes from {}: its outline is not drawn.", mesh.file));
  for (const auto& [name, support] : c.support)
    sketch.notes.push_back(
        fmt::format("Held at its boundary \"{}\": {}{}.", support.boundary, text_of_list(support.fixed, ", "), motion_words(support)));
}

void add_bodies(Sketch& sketch, const settings::Case& c)
{
  for (const auto& [name, body] : c.body) {
    if (body.block)
      sketch.bodies.push_back({name, outline_of(bodies::BoxSettings{body.block->center, body.block->size, body.block->angle})});
    if (body.disk) sketch.bodies.push_back({name, DiskOutline{in_plane(body.disk->center), body.disk->diameter / 2}});
    if (body.has_k0() && sketch.ground.line.level()) sketch.surface = c.surface;
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
  for (const base::EarthworkWords& work : base::earthworks_in_words(c))
    sketch.earthworks.push_back({work.body, work.material, work.words, outline_of(work.settings.area)});
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

/// What the drawing, the plane x-y, does not show of a case in space.
std::string space_note(const settings::Case& c)
{
  std::string words = "The case is three-dimensional: drawn are the sides of its mesh and bodies in the plane x-y, y up";
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh); box != nullptr && box->size.size() == 3) {
    const Real from = box->lower.empty() ? 0 : box->lower[2];
    words += fmt::format("; along z, towards the viewer, the mesh extends from {:.4g} m to {:.4g} m", from, from + box->size[2]);
  }
  return words + ".";
}

void add_notes(Sketch& sketch, const settings::Case& c)
{
  for (const auto& [name, support] : c.support)
    if (!sketch.outline.empty() && (support.boundary == "back" || support.boundary == "front"))
      sketch.notes.push_back(fmt::format("Held at the boundary \"{}\", parallel to the drawing: {}{}.", support.boundary,
                                         text_of_list(support.fixed, ", "), motion_words(support)));
  if (settings::has_flowing_water(c) && !sketch.outline.empty()) {
    std::string open = "Water leaves the soil at its free surface";
    for (const auto& [name, contact] : c.contact)
      if (contact.drained) open += fmt::format(" and through \"{}\"", contact.rigid);
    sketch.notes.push_back(open + ".");
  }
  if (c.geometry == settings::Geometry::axisymmetric)
    sketch.notes.emplace_back("The case is axisymmetric: x is the radius, and the left edge is the axis.");
  if (c.dimension() == 3) sketch.notes.push_back(space_note(c));
}

/// How far a drive goes in its time: it grows evenly from nothing within the ramp.
std::optional<Real> travel_in_time(const settings::StageSettings& stage)
{
  if (!stage.velocity || !stage.until.time) return {};
  return std::abs(*stage.velocity) * std::max(0., *stage.until.time - stage.ramp / 2);
}

void add_path(Sketch& sketch, const settings::Case& c)
{
  std::vector<Vec<2>> centers;
  for (const NamedOutline& rigid : sketch.rigid_bodies) centers.push_back(middle_of(rigid.outline));
  for (int k = 0; k < static_cast<int>(c.stage.size()); ++k) {
    const settings::StageSettings& stage = c.stage[k];
    const bool push = stage.kind == settings::StageKind::push, drag = stage.kind == settings::StageKind::drag;
    if ((!push && !drag) || c.rigid.empty()) continue;
    const int rigid = static_cast<int>(stage.rigid.empty() ? 0 : index_of(c.rigid, stage.rigid));
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
      else if (drag && stage.vertical == settings::Vertical::hold && !sketch.ground.line.level())
        to[1] += sketch.ground.line.height(to[0]) - sketch.ground.line.height(from[0]);
    }
    if ((to - from).norm() > 0) sketch.path.push_back({k, rigid, from, to, known});
    if (known) centers[rigid] = to;
  }
}

}  // namespace

Points corners_of(const Extent& extent)
{
  return {extent.lower, Vec<2>(extent.upper[0], extent.lower[1]), extent.upper, Vec<2>(extent.lower[0], extent.upper[1])};
}

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

Points part_inside(const PlaneOutline& plane, const Extent& extent)
{
  return cut(corners_of(extent), [&](const Vec<2>& x) { return (plane.point - x).dot(plane.normal); });
}

Sketch sketch_of(const settings::Case& settings, const problem::Ground& ground)
{
  Sketch sketch;
  sketch.ground = ground;
  std::visit([&](const auto& mesh) { add_mesh(sketch, settings, mesh); }, settings.mesh);
  add_bodies(sketch, settings);
  if (sketch.outline.empty())
    take_domain_from_bodies(sketch);
  else
    sketch.domain = extent_of(CornersOutline{sketch.outline});
  add_path(sketch, settings);
  sketch.gravity = in_plane(settings.gravity);
  add_notes(sketch, settings);
  return sketch;
}

}  // namespace berm::picture
