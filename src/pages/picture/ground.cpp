// SPDX-License-Identifier: BSD-3-Clause
#include "picture/ground.hpp"

#include "bodies/fill.hpp"
#include "picture/stage_words.hpp"
#include "problem/absorbing.hpp"
#include "problem/model.hpp"
#include "settings/drainage.hpp"
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
namespace {

/// The soil of a body and the numbers that its materials have among the kinds.
struct BodyKinds {
  settings::BodySoil soil;
  Index first;
};

std::vector<BodyKinds> kinds_of(const settings::Case& c, std::vector<SoilKind>& kinds)
{
  std::vector<BodyKinds> bodies;
  for (const auto& [name, settings] : c.body) {
    bodies.push_back({soil_of(c, settings), static_cast<Index>(kinds.size())});
    for (const std::string& material : bodies.back().soil.names) kinds.push_back({name, material, &c});
  }
  return bodies;
}

Index filled_by(const settings::Case& c, const std::string& region)
{
  const auto fills = [&](const auto& body) {
    return std::find(body.second.regions.begin(), body.second.regions.end(), region) != body.second.regions.end();
  };
  const auto found = std::find_if(c.body.begin(), c.body.end(), fills);
  return found == c.body.end() ? none : static_cast<Index>(found - c.body.begin());
}

/// The surface that depth in the soil counts from.
struct Surface {
  Surface(const settings::Case& c, const problem::Ground& bed)
      : axes(axes_of<2>(bodies::to_vec<2>(c.gravity))),
        level(c.surface),
        line(bed.laid_down)
  {
  }

  Real depth(const Vec<2>& x, const Vec<2>& below) const { return axes.depth(x, line.level() ? level : line.height(below[axes.along])); }

  Axes<2> axes;
  Real level;
  const mesh::GroundLine& line;
};

/// A convex part of a region, cut where its body has another layer.
void add_pieces(const BodyKinds& body, const std::string& region, const Surface& surface, const Points& corners, std::vector<Piece>& pieces)
{
  const settings::BodySoil& soil = body.soil;
  if (soil.layers.empty()) return pieces.push_back({corners, body.first + soil.material_index_at(region, 0)});
  Vec<2> middle = Vec<2>::Zero();
  for (const Vec<2>& corner : corners) middle += corner / static_cast<Real>(corners.size());
  // At a vertical face the level is that on the part's side of it.
  const auto depth = [&](const Vec<2>& x) { return surface.depth(x, x + 1e-9 * (middle - x)); };
  for (std::size_t layer = 0; layer <= soil.layers.size(); ++layer) {
    Points part = corners;
    if (layer > 0) part = cut(part, [&](const Vec<2>& x) { return depth(x) - soil.layers[layer - 1].top; });
    if (layer < soil.layers.size()) part = cut(part, [&](const Vec<2>& x) { return soil.layers[layer].top - depth(x); });
    if (part.size() >= 3) pieces.push_back({part, body.first + (layer == 0 ? 0 : soil.layers[layer - 1].material)});
  }
}

/// The side of a cell across from a corner.
Side side_of(const mesh::Mesh<2>& mesh, Index cell, int corner)
{
  const auto& nodes = mesh.nodes[cell];
  const Vec<2>&from = mesh.position[nodes[(corner + 1) % 3]], &to = mesh.position[nodes[(corner + 2) % 3]];
  const Vec<2> way = to - from;  // corners run counter-clockwise
  return {from, to, Vec<2>(way[1], -way[0]).normalized()};
}

/// A support without its sides.
HeldSides held_of(const settings::Case& c, const boundary::SupportSettings& support)
{
  return {held_words(c, support), support.boundary, fixed_directions(support), {}};
}

HeldSides held_sides(const settings::Case& c, const mesh::Mesh<2>& mesh, const std::string& name, const boundary::SupportSettings& support)
{
  HeldSides held = held_of(c, support);
  const std::vector<Index>& nodes = mesh.boundary_nodes[fixed_boundary(mesh, name, support)];
  const auto is_held = [&](Index node) { return std::binary_search(nodes.begin(), nodes.end(), node); };
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int corner = 0; corner < 3; ++corner)
      if (is_held(mesh.nodes[cell][(corner + 1) % 3]) && is_held(mesh.nodes[cell][(corner + 2) % 3]) && mesh.neighbor(cell, corner) == none)
        held.sides.push_back(side_of(mesh, cell, corner));
  return held;
}

bool is_held(const Ground& ground, const Side& side)
{
  return std::any_of(ground.held.begin(), ground.held.end(), [&](const HeldSides& held) {
    return std::any_of(held.sides.begin(), held.sides.end(),
                       [&](const Side& other) { return other.from == side.from && other.to == side.to; });
  });
}

/// An upright rectangle of a mesh that berm makes, in a bed before its slope and its trench.
struct Region {
  std::string name;
  Extent extent;
};

std::vector<Region> regions_of(const mesh::SeabedMesh& bed)
{
  const auto [left, right, far_size] = layout_of(bed);
  const mesh::FineZone near = fine_zone_of(bed);
  const Real base = -bed.depth, wall = near.left > left ? bed.layer : 0, far_left = left + wall, far_right = right - bed.layer,
             floor = base + bed.layer;
  const auto region = [](const char* name, Real from, Real to, Real lower, Real upper) {
    return Region{name, {Vec<2>(from, lower), Vec<2>(to, upper)}};
  };
  return {region("headroom", left, right, 0, bed.headroom),
          region("layer", left, far_left, base, 0),
          region("layer", far_right, right, base, 0),
          region("layer", far_left, far_right, base, floor),
          region("bed", far_left, near.left, floor, 0),
          region("bed", near.right, far_right, floor, 0),
          region("bed", near.left, near.right, floor, near.lower),
          region("near", near.left, near.right, near.lower, 0)};
}

std::vector<Region> regions_of(const mesh::BoxMesh& box)
{
  const Vec<2> lower = bodies::to_vec<2>(box.lower);
  return {{"box", {lower, lower + bodies::to_vec<2>(box.size)}}};
}

std::vector<Region> regions_of(const mesh::GmshFile& /*file*/)
{
  return {};
}

/// The parts of a region below the surface of a bed that is not level, or above it, between its corners.
std::vector<Points> parts_of(const Region& region, Real slope, const std::vector<Vec<2>>& surface, const Extent& mesh)
{
  const bool above = region.name == "headroom";
  Extent extent = region.extent;
  (above ? extent.lower : extent.upper)[1] = above ? mesh.lower[1] : mesh.upper[1];
  Points whole = corners_of(extent);
  for (Vec<2>& corner : whole) corner[1] += std::tan(slope) * corner[0];
  std::vector<Points> parts;
  for (std::size_t k = 1; k < surface.size(); ++k) {
    const Vec<2>&from = surface[k - 1], way = surface[k] - from;
    if (!(way[0] > 0)) continue;
    Points part = cut(whole, [&](const Vec<2>& x) { return x[0] - from[0]; });
    part = cut(part, [&](const Vec<2>& x) { return from[0] + way[0] - x[0]; });
    part = cut(part, [&](const Vec<2>& x) { return (above ? 1 : -1) * (x[1] - from[1] - way[1] / way[0] * (x[0] - from[0])); });
    if (part.size() >= 3) parts.push_back(part);
  }
  return parts;
}

}  // namespace

Index kind_of(const Ground& ground, const std::string& body)
{
  const auto found = std::find_if(ground.kinds.begin(), ground.kinds.end(), [&](const SoilKind& kind) { return kind.body == body; });
  return found == ground.kinds.end() ? none : static_cast<Index>(found - ground.kinds.begin());
}

Index kind_of(const Ground& ground, const std::string& body, const std::string& material)
{
  const auto found = std::find_if(ground.kinds.begin(), ground.kinds.end(),
                                  [&](const SoilKind& kind) { return kind.body == body && kind.material == material; });
  return found == ground.kinds.end() ? kind_of(ground, body) : static_cast<Index>(found - ground.kinds.begin());
}

Ground ground_of(const settings::Case& c, const Sketch& sketch)
{
  Ground ground;
  ground.lower = sketch.domain.lower;
  ground.upper = sketch.domain.upper;
  const std::vector<BodyKinds> bodies = kinds_of(c, ground.kinds);
  const Vec<2> up(0, 1);
  if (sketch.surface) ground.surface.push_back({{ground.lower[0], *sketch.surface}, {ground.upper[0], *sketch.surface}, up});
  const std::vector<Vec<2>>& corners = sketch.ground.line.corners;
  for (std::size_t k = 1; k < corners.size(); ++k) ground.surface.push_back({corners[k - 1], corners[k], up});
  if (sketch.outline.empty()) return ground;
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  const Surface surface(c, sketch.ground);
  ground.pieces.push_back({sketch.outline, none});
  for (const Region& region : std::visit([](const auto& mesh) { return regions_of(mesh); }, c.mesh)) {
    const Index body = filled_by(c, region.name);
    if (body == none || !(region.extent.size().minCoeff() > 0)) continue;
    const std::vector<Points> parts = bed == nullptr || corners.empty() ? std::vector<Points>{corners_of(region.extent)}
                                                                        : parts_of(region, bed->slope, corners, sketch.domain);
    for (const Points& part : parts) add_pieces(bodies[body], region.name, surface, part, ground.pieces);
  }
  const Points& at = sketch.outline;
  for (const auto& [name, support] : c.support) {
    HeldSides held = held_of(c, support);
    const auto hold = [&](std::initializer_list<const char*> names, int from, int to, const Vec<2>& outward) {
      if (std::find(names.begin(), names.end(), support.boundary) != names.end()) held.sides.push_back({at[from], at[to], outward});
    };
    hold({"left"}, 0, 3, {-1, 0});
    hold({"right"}, 1, 2, {1, 0});
    hold({"base", "bottom"}, 0, 1, {0, -1});
    hold({"top"}, 3, 2, {0, 1});
    ground.held.push_back(held);
  }
  return ground;
}

Ground ground_of(const settings::Case& c, const mesh::Mesh<2>& mesh, const problem::Ground& bed)
{
  Ground ground;
  ground.lower = mesh.lower;
  ground.upper = mesh.upper;
  ground.cells = mesh.cell_count();
  const std::vector<BodyKinds> bodies = kinds_of(c, ground.kinds);
  const std::vector<Index> body_of = problem::bodies_of_regions(mesh, c);
  const Surface surface(c, bed);
  for (const auto& [name, support] : c.support) ground.held.push_back(held_sides(c, mesh, name, support));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Index body = body_of[mesh.region[cell]];
    Points corners;
    for (const Index node : mesh.nodes[cell]) corners.push_back(mesh.position[node]);
    if (body == none) {
      ground.pieces.push_back({corners, none});
      continue;
    }
    add_pieces(bodies[body], mesh.region_names[mesh.region[cell]], surface, corners, ground.pieces);
    for (int corner = 0; corner < 3; ++corner) {
      const Index beside = mesh.neighbor(cell, corner);
      const Side side = side_of(mesh, cell, corner);
      const bool open = beside == none ? side.outward.dot(surface.axes.up_vector()) > 0.3 && !is_held(ground, side)
                                       : body_of[mesh.region[beside]] == none;
      if (open) ground.surface.push_back(side);
    }
  }
  for (const auto& [name, traction] : c.traction)
    for (const boundary::LoadedPoint<2>& point : loaded_points(mesh, name, traction, body_of))
      if (point.force.norm() > 0) ground.loaded.push_back({name, point.x, point.force.normalized()});
  return ground;
}

}  // namespace berm::picture
