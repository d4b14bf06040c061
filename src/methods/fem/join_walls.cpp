// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/join_walls_test.cpp
#include "fem/outline.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

constexpr Real touching = 0.05;   // of the shorter side beside it: a corner at this distance from the wall is on it
constexpr Real first_side = 0.1;  // of the sides beside the first corner on a wall, each: the side that takes its place

Real distance(const Wall& wall, const Vec<2>& x)
{
  return (x[0] - wall.x) * wall.inwards;
}

std::size_t before(const OutlineLoop& loop, std::size_t k)
{
  return (k + loop.size() - 1) % loop.size();
}

std::size_t behind(const OutlineLoop& loop, std::size_t k)
{
  return (k + 1) % loop.size();
}

/// Makes a corner of the middle of a free side that bulges beyond the wall.
void divide_bulges(OutlineLoop& loop, const Wall& wall)
{
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (!loop[k].free || !(distance(wall, loop[k].middle.x) < 0)) continue;
    OutlineSide second = loop[k];
    second.corner = second.middle;
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(k + 1), second);
    straighten(loop, k);
    straighten(loop, k + 1);
    ++k;
  }
}

/// Puts free corners that have come to the wall onto it; true where there was one.
bool put_on_wall(OutlineLoop& loop, const Wall& wall)
{
  const OutlineLoop old = loop;
  bool any = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t last = before(loop, k), next = behind(loop, k);
    if (!loop[last].free || !loop[k].free) continue;
    const Vec<2>& x = old[k].corner.x;
    const Real length = std::min((x - old[last].corner.x).norm(), (x - old[next].corner.x).norm());
    if (!(distance(wall, x) < touching * length)) continue;
    loop[k].corner.x[0] = wall.x;
    for (const std::size_t side : {last, k}) straighten(loop, side);
    any = true;
  }
  return any;
}

/// Free ground from corner to corner of the wall.
bool closes(const OutlineLoop& loop, std::size_t side, const Wall& wall)
{
  return loop[side].free && distance(wall, loop[side].corner.x) == 0 && distance(wall, loop[behind(loop, side)].corner.x) == 0;
}

/// Whether the soil lies inwards of a side on the wall, as the outline has it on its left.
bool is_along(const OutlineLoop& loop, std::size_t side, const Wall& wall)
{
  return (loop[behind(loop, side)].corner.x[1] - loop[side].corner.x[1]) * wall.inwards < 0;
}

/// Where ground that closes goes back along the wall its end has no soil behind it.
void drop_spikes(OutlineLoop& loop, const Wall& wall)
{
  for (std::size_t k = 0; k < loop.size() && loop.size() > 3;) {
    if (!closes(loop, k, wall) || is_along(loop, k, wall)) {
      ++k;
      continue;
    }
    const std::size_t end = behind(loop, k);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(end));
    straighten(loop, end > k ? k : k - 1);
    k = 0;
  }
}

/// Makes a side on the wall of a corner that lies there alone, so that the wall holds it.
void widen_lone_corners(OutlineLoop& loop, const Wall& wall)
{
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t last = before(loop, k), next = behind(loop, k);
    if (!loop[last].free || !loop[k].free || distance(wall, loop[k].corner.x) != 0) continue;
    if (closes(loop, last, wall) || closes(loop, k, wall)) continue;
    Vec<2> first = loop[k].corner.x + first_side * (loop[last].corner.x - loop[k].corner.x),
           second = loop[k].corner.x + first_side * (loop[next].corner.x - loop[k].corner.x);
    first[0] = second[0] = wall.x;
    if (!((second[1] - first[1]) * wall.inwards < 0)) continue;
    OutlineSide added = loop[k];
    added.corner.x = first;
    loop[k].corner.x = second;
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(k), added);
    straighten(loop, before(loop, k));
    straighten(loop, k + 1);
    ++k;
  }
}

/// Gives sides from corner to corner of the wall to it. Gives the number of places that were no neighbours of it.
int take(OutlineLoop& loop, const Wall& wall)
{
  std::vector<char> is_new(loop.size(), 0);
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (closes(loop, k, wall)) is_new[k] = 1;
  int places = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (!is_new[k]) continue;
    loop[k].boundary = wall.boundary;
    loop[k].free = false;
    straighten(loop, k);
    if (is_new[before(loop, k)]) continue;
    std::size_t end = behind(loop, k);
    while (is_new[end] && end != k) end = behind(loop, end);
    if (loop[before(loop, k)].boundary != wall.boundary && loop[end].boundary != wall.boundary) ++places;
  }
  return places;
}

}  // namespace

std::vector<Wall> walls_of(const FemModel& model, const FemState& state)
{
  const NodeField<std::uint8_t>& fixed = model.mesh.fixed[model.model.conditions.table_of_stage[state.state.stage.index]];
  Real left = infinity, right = -infinity;
  for (const Vec<2>& x : model.mesh.position) left = std::min(left, x[0]), right = std::max(right, x[0]);
  std::vector<Wall> walls;
  std::vector<Real> tops;
  for (Index boundary = 0; boundary < static_cast<Index>(model.model.mesh.boundary_names.size()); ++boundary) {
    bool is_wall = true;
    const BoundarySide* first = nullptr;
    Real top = -infinity;
    for (const BoundarySide& side : model.mesh.boundary_sides) {
      if (side.boundary != boundary || is_ground(model.model.mesh, side)) continue;
      if (first == nullptr) first = &side;
      const Real x = model.mesh.position[first->from][0];
      for (const Index node : {side.from, side.to}) {
        is_wall = is_wall && (fixed[node] & 1) != 0 && model.mesh.position[node][0] == x;
        top = std::max(top, model.mesh.position[node][1]);
      }
    }
    if (first == nullptr || !is_wall) continue;
    const Real x = model.mesh.position[first->from][0];
    if (x != left && x != right) continue;
    const auto same = std::ranges::find(walls, x, &Wall::x);
    const auto number = static_cast<std::size_t>(same - walls.begin());
    if (same != walls.end() && tops[number] >= top) continue;
    if (same == walls.end()) walls.emplace_back(), tops.emplace_back();
    walls[number] = {x, x == left ? Real(1) : Real(-1), boundary};
    tops[number] = top;
  }
  return walls;
}

bool is_beyond_wall(const FemModel& model, const FemState& state)
{
  const NodeField<char> closed = nodes_in_contact(model, state);
  for (const Wall& wall : walls_of(model, state))
    for (const BoundarySide& side : model.mesh.boundary_sides)
      if (is_ground(model.model.mesh, side))
        for (const Index node : {side.from, side.middle, side.to})
          if (!closed[node] && distance(wall, position_now(model, state, node)) < 0) return true;
  return false;
}

int join_walls(std::vector<OutlineLoop>& loops, const std::vector<Wall>& walls)
{
  int places = 0;
  for (OutlineLoop& loop : loops)
    for (const Wall& wall : walls) {
      divide_bulges(loop, wall);
      if (!put_on_wall(loop, wall)) continue;
      drop_spikes(loop, wall);
      widen_lone_corners(loop, wall);
      places += take(loop, wall);
    }
  return places;
}

}  // namespace berm::fem
