// SPDX-License-Identifier: BSD-3-Clause
#include "problem/ground.hpp"

#include "core/axes.hpp"

#include <algorithm>

namespace berm::problem {
namespace {

/// A side of the soil that looks upwards.
struct UpperSide {
  Vec<2> left, right;

  Real height(Real x) const { return left[1] + (x - left[0]) / (right[0] - left[0]) * (right[1] - left[1]); }
};

std::vector<char> filled_cells(const settings::Case& c, const mesh::Mesh<2>& mesh)
{
  std::vector<char> fills(mesh.region_names.size(), 0), filled(mesh.cell_count(), 0);
  for (const auto& [name, body] : c.body)
    for (const std::string& region : body.regions)
      if (const Index r = mesh.find_region(region); r != none) fills[r] = 1;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) filled[cell] = fills[mesh.region[cell]];
  return filled;
}

/// The sides of filled cells with nothing filled beyond them whose outward normal points upwards.
std::vector<UpperSide> upper_sides(const mesh::Mesh<2>& mesh, const std::vector<char>& filled)
{
  const Real margin = 1e-9 * (mesh.upper[0] - mesh.lower[0]);
  std::vector<UpperSide> sides;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int corner = 0; filled[cell] && corner < 3; ++corner) {
      const Index beyond = mesh.neighbor(cell, corner);
      if (beyond != none && filled[beyond]) continue;
      // Cells are oriented counter-clockwise: what lies right of a side is outside, and a side above the cell goes to the left.
      const Vec<2>&from = mesh.position[mesh.nodes[cell][(corner + 1) % 3]], &to = mesh.position[mesh.nodes[cell][(corner + 2) % 3]];
      if (to[0] < from[0] - margin) sides.push_back({to, from});
    }
  std::sort(sides.begin(), sides.end(), [](const UpperSide& a, const UpperSide& b) { return a.left[0] < b.left[0]; });
  return sides;
}

/// The highest sides from left to right.
mesh::GroundLine envelope_of(const std::vector<UpperSide>& sides)
{
  std::vector<Real> xs;
  for (const UpperSide& side : sides) xs.insert(xs.end(), {side.left[0], side.right[0]});
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  mesh::GroundLine line;
  std::vector<const UpperSide*> here;
  std::size_t next = 0;
  for (std::size_t k = 0; k + 1 < xs.size(); ++k) {
    std::erase_if(here, [&](const UpperSide* side) { return side->right[0] <= xs[k]; });
    for (; next < sides.size() && sides[next].left[0] <= xs[k]; ++next) here.push_back(&sides[next]);
    const Real middle = (xs[k] + xs[k + 1]) / 2;
    const auto highest = std::max_element(here.begin(), here.end(),
                                          [&](const UpperSide* a, const UpperSide* b) { return a->height(middle) < b->height(middle); });
    if (highest == here.end()) continue;
    for (const Real x : {xs[k], xs[k + 1]}) {
      const Vec<2> corner(x, (*highest)->height(x));
      if (line.corners.empty() || line.corners.back() != corner) line.corners.push_back(corner);
    }
  }
  return line;
}

bool up_is_y(const settings::Case& c)
{
  const Axes<2> axes = axes_of<2>(bodies::to_vec<2>(c.gravity));
  return axes.up == 1 && axes.sign > 0;
}

}  // namespace

void Ground::take_found(mesh::GroundLine found)
{
  line = std::move(found);
  laid_down = embedment_counts_from_it ? line : mesh::GroundLine{};
}

Ground ground_of(const settings::Case& c)
{
  Ground ground;
  ground.embedment_counts_from_it = !c.surface_given;
  const auto* file = std::get_if<mesh::GmshFile>(&c.mesh);
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (file != nullptr && file->made_from) bed = &*file->made_from;
  if (bed == nullptr) return ground;
  ground.line = ground_of(*bed);
  ground.laid_down = ground_before_trench(*bed);
  return ground;
}

bool loads_by_gravity(const settings::Case& c, const Ground& ground)
{
  if (c.initial_state != settings::InitialState::automatic) return c.initial_state == settings::InitialState::gravity_loading;
  const auto has_k0 = [](const auto& body) { return body.second.has_k0(); };
  const bool any_gravity = std::any_of(c.gravity.begin(), c.gravity.end(), [](Real g) { return g != 0; });
  return any_gravity && !ground.line.level() && std::any_of(c.body.begin(), c.body.end(), has_k0);
}

Ground ground_in(const settings::Case& c, const mesh::Mesh<2>& mesh, const std::vector<bodies::RigidShape<2>>& rigid_bodies)
{
  Ground ground = ground_of(c);
  const auto* file = std::get_if<mesh::GmshFile>(&c.mesh);
  if (file == nullptr || file->made_from || !up_is_y(c) || c.gravity.empty()) return ground;
  mesh::GroundLine line = envelope_of(upper_sides(mesh, filled_cells(c, mesh)));
  for (const bodies::RigidShape<2>& shape : rigid_bodies) {
    if (!bodies::is_bounded<2>(shape)) continue;
    const Real rounding = 1e-6 * bodies::reach_of<2>(shape);
    std::erase_if(line.corners, [&](const Vec<2>& x) { return surface_at<2>(shape, x).distance < rounding; });
  }
  ground.take_found(simplified(line));
  return ground;
}

}  // namespace berm::problem
