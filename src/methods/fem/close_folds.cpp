// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/close_folds_test.cpp
#include "fem/outline.hpp"

#include <algorithm>
#include <optional>

namespace berm::fem {
namespace {

constexpr Real touching = 0.15;  // of a side: two surfaces at this distance are one
constexpr std::size_t knot = 3;  // sides, where a tip of soil is squeezed against the body
constexpr std::size_t tied = 6;  // sides at most between two that cross, of which one is in contact: fewer than go around a body

const Vec<2>& end_of(const OutlineLoop& loop, std::size_t side)
{
  return loop[(side + 1) % loop.size()].corner.x;
}

Real length_of(const OutlineLoop& loop, std::size_t side)
{
  return (end_of(loop, side) - loop[side].corner.x).norm();
}

/// Whether a corner of free ground touches a side.
bool touches(const OutlineLoop& loop, std::size_t corner, std::size_t side)
{
  const Vec<2>&a = loop[side].corner.x, &x = loop[corner].corner.x, along = end_of(loop, side) - a;
  const Real part = std::clamp((x - a).dot(along) / along.squaredNorm(), Real(0), Real(1));
  return (a + part * along - x).norm() < touching * std::min({length_of(loop, side), length_of(loop, corner), length_of(loop, corner - 1)});
}

bool cross(const OutlineLoop& loop, std::size_t first, std::size_t second)
{
  const auto turn = [](const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) { return (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]; };
  const Vec<2>&a = loop[first].corner.x, &b = end_of(loop, first), &c = loop[second].corner.x, &d = end_of(loop, second);
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// The sides from one to before another.
OutlineLoop part_of(const OutlineLoop& loop, std::size_t first, std::size_t last)
{
  return {loop.begin() + static_cast<std::ptrdiff_t>(first), loop.begin() + static_cast<std::ptrdiff_t>(last)};
}

/// Whether what lies between these corners is no soil.
bool is_void(const OutlineLoop& loop, std::size_t first, std::size_t last)
{
  return area_within(part_of(loop, first, last + 1)) < 0;
}

/// Makes one side from corner `first` to corner `last`. Gives what lay between, where that is a void around the body: a loop of its own.
OutlineLoop cut(OutlineLoop& loop, std::size_t first, std::size_t last)
{
  OutlineLoop between = part_of(loop, first + 1, last);
  const bool is_hole =
      between.size() > knot && std::ranges::any_of(between, [](const OutlineSide& side) { return !side.free; }) && area_within(between) < 0;
  // Not to a corner that is so near that the side would be short.
  if (last + 1 < loop.size() && loop[last].free && (loop[last].corner.x - loop[first].corner.x).norm() < length_of(loop, last) / 2) ++last;
  loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(first + 1), loop.begin() + static_cast<std::ptrdiff_t>(last));
  straighten(loop, first);
  if (!is_hole) return {};
  straighten(between, between.size() - 1);
  return between;
}

/// Corners between which a loop is to be cut.
std::optional<std::pair<std::size_t, std::size_t>> fold_of(const OutlineLoop& loop)
{
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    for (std::size_t j = k + 2; j + 1 < loop.size(); ++j)
      if ((j <= k + tied || (loop[k].free && loop[j].free)) && cross(loop, k, j)) return std::pair{k, j + 1};
    if (!loop[k - 1].free || !loop[k].free) continue;
    for (std::size_t j = 1; j + 1 < loop.size(); ++j) {
      if (j == k || j + 1 == k || !loop[j].free || !touches(loop, k, j)) continue;
      const auto [first, last] = j < k ? std::pair{j, k} : std::pair{k, j + 1};
      if (is_void(loop, first, last)) return std::pair{first, last};
    }
  }
  return {};
}

}  // namespace

int close_folds(std::vector<OutlineLoop>& loops)
{
  int folds = 0;
  for (std::size_t l = 0; l < loops.size(); ++l)
    while (const auto fold = fold_of(loops[l])) {
      ++folds;
      if (OutlineLoop hole = cut(loops[l], fold->first, fold->second); !hole.empty()) loops.push_back(std::move(hole));
    }
  return folds;
}

}  // namespace berm::fem
