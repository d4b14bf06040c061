// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/ground_test.cpp
#include "run_folder/ground.hpp"

#include <algorithm>
#include <map>

namespace berm::run_folder {
namespace {

constexpr Real on_wall = 1e-6;  // of the length of the soil

/// A side of one element alone leads from a corner of it by its middle to the next.
struct Side {
  Index middle, end;
};
using Boundary = std::multimap<Index, Side>;

Boundary boundary_of(const std::vector<std::array<Index, 6>>& triangles)
{
  std::map<std::pair<Index, Index>, std::pair<int, Index>> sides;  // how many elements have it, and its middle
  for (const std::array<Index, 6>& t : triangles)
    for (int k = 0; k < 3; ++k) {
      auto& [count, middle] = sides[std::minmax({t[k], t[(k + 1) % 3]})];
      ++count, middle = t[3 + k];
    }
  Boundary boundary;
  for (const auto& [ends, side] : sides) {
    if (side.first != 1) continue;
    boundary.insert({ends.first, {side.second, ends.second}});
    boundary.insert({ends.second, {side.second, ends.first}});
  }
  return boundary;
}

}  // namespace

std::vector<Index> ground_points(const SavedSoil& soil)
{
  if (soil.triangles.empty()) return {};
  const auto [left, right] = std::ranges::minmax(soil.x);
  const Real close = on_wall * (right - left);
  const auto is_at = [&](Index point, Real wall) { return std::abs(soil.x[point] - wall) <= close; };
  const Boundary boundary = boundary_of(soil.triangles);
  Index at = none;
  for (const auto& [corner, side] : boundary)
    if (is_at(corner, left) && (at == none || soil.y[corner] > soil.y[at])) at = corner;
  if (at == none) return {};
  std::vector<Index> points = {at};
  for (Index before = none; !is_at(at, right);) {
    const auto [first, last] = boundary.equal_range(at);
    const auto next = std::find_if(first, last, [&](const auto& entry) {
      const Index end = entry.second.end;
      return end != before && !(is_at(at, left) && is_at(end, left));
    });
    if (next == last || points.size() > 2 * boundary.size()) return {};
    points.push_back(next->second.middle), points.push_back(next->second.end);
    before = at, at = next->second.end;
  }
  return points;
}

}  // namespace berm::run_folder
