// SPDX-License-Identifier: BSD-3-Clause
#include "picture/ground.hpp"

#include "bodies/fill.hpp"
#include "problem/model.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::picture {
namespace {

/// The soil of a body and the numbers that its materials have among the kinds.
struct BodyKinds {
  problem::BodySoil soil;
  Index first;
};

std::vector<BodyKinds> kinds_of(const problem::Case& c, std::vector<SoilKind>& kinds)
{
  std::vector<BodyKinds> bodies;
  for (const auto& [name, settings] : c.body) {
    bodies.push_back({soil_of(c, settings), static_cast<Index>(kinds.size())});
    for (const std::string& material : bodies.back().soil.names) kinds.push_back({name, material, &c});
  }
  return bodies;
}

/// The body of each region, the first where several fill it, or none.
std::vector<Index> bodies_of_regions(const problem::Case& c, const mesh::Mesh<2>& mesh)
{
  std::vector<Index> body_of(mesh.region_names.size(), none);
  for (Index b = static_cast<Index>(c.body.size()); b-- > 0;)
    for (const std::string& region : c.body[b].second.regions) body_of[bodies::filled_region(mesh, c.body[b].first, region)] = b;
  return body_of;
}

/// A cell, cut where its body has another layer; level_above(x) is the level that depth at x counts from.
template <class Level>
void add_pieces(const BodyKinds& body, const std::string& region, const problem::Axes<2>& axes, const Level& level_above,
                const Points& corners, std::vector<Piece>& pieces)
{
  const problem::BodySoil& soil = body.soil;
  if (soil.layers.empty()) return pieces.push_back({corners, body.first + soil.material_index_at(region, 0)});
  Vec<2> middle = Vec<2>::Zero();
  for (const Vec<2>& corner : corners) middle += corner / static_cast<Real>(corners.size());
  // At a vertical face the level is that on the cell's side of it.
  const auto depth = [&](const Vec<2>& x) { return axes.depth(x, level_above(x + 1e-9 * (middle - x))); };
  for (std::size_t layer = 0; layer <= soil.layers.size(); ++layer) {
    Points part = corners;
    if (layer > 0) part = report::cut(part, [&](const Vec<2>& x) { return depth(x) - soil.layers[layer - 1].top; });
    if (layer < soil.layers.size()) part = report::cut(part, [&](const Vec<2>& x) { return soil.layers[layer].top - depth(x); });
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

HeldSides held_sides(const mesh::Mesh<2>& mesh, const std::string& name, const boundary::SupportSettings& support)
{
  HeldSides held{fmt::format("{} fixed", fmt::join(support.fixed, ", ")), support.boundary, fixed_directions(support), {}};
  if (!support.stages.empty()) held.words += fmt::format(" in {}", fmt::join(support.stages, ", "));
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

}  // namespace

Index kind_of(const Ground& ground, const std::string& body)
{
  const auto found = std::find_if(ground.kinds.begin(), ground.kinds.end(), [&](const SoilKind& kind) { return kind.body == body; });
  return found == ground.kinds.end() ? none : static_cast<Index>(found - ground.kinds.begin());
}

Ground ground_of(const problem::Case& c, const mesh::Mesh<2>& mesh, const problem::Ground& bed)
{
  Ground ground;
  ground.lower = mesh.lower;
  ground.upper = mesh.upper;
  ground.cells = mesh.cell_count();
  const std::vector<BodyKinds> bodies = kinds_of(c, ground.kinds);
  const std::vector<Index> body_of = bodies_of_regions(c, mesh);
  const auto axes = problem::axes_of<2>(c.gravity.size() == 2 ? Vec<2>(c.gravity[0], c.gravity[1]) : Vec<2>(Vec<2>::Zero()));
  const auto level_above = [&](const Vec<2>& x) { return bed.laid_down.level() ? c.surface : bed.laid_down.height(x[axes.along]); };
  for (const auto& [name, support] : c.support) ground.held.push_back(held_sides(mesh, name, support));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Index body = body_of[mesh.region[cell]];
    Points corners;
    for (const Index node : mesh.nodes[cell]) corners.push_back(mesh.position[node]);
    if (body == none) {
      ground.pieces.push_back({corners, none});
      continue;
    }
    add_pieces(bodies[body], mesh.region_names[mesh.region[cell]], axes, level_above, corners, ground.pieces);
    for (int corner = 0; corner < 3; ++corner) {
      const Index beside = mesh.neighbor(cell, corner);
      const Side side = side_of(mesh, cell, corner);
      const bool open =
          beside == none ? side.outward.dot(axes.up_vector()) > 0.3 && !is_held(ground, side) : body_of[mesh.region[beside]] == none;
      if (open) ground.surface.push_back(side);
    }
  }
  for (const auto& [name, traction] : c.traction)
    for (const boundary::LoadedPoint<2>& point : loaded_points(mesh, name, traction, body_of))
      if (point.force.norm() > 0) ground.loaded.push_back({name, point.x, point.force.normalized()});
  return ground;
}

}  // namespace berm::picture
