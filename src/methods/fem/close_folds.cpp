// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/close_folds_test.cpp
#include "fem/outline.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

Real distance(const OutlineLoop& loop, std::size_t from, std::size_t to)
{
  return (loop.corners[to % loop.corners.size()].x - loop.corners[from].x).norm();
}

Real length_of(const OutlineLoop& loop, std::size_t k)
{
  return distance(loop, k, k + 1);
}

class FoldCloser {
public:
  explicit FoldCloser(std::vector<OutlineLoop>& loops) : loops_(loops) {}

  /// The number of folds.
  int close()
  {
    int folds = 0;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      while (close_one(l)) ++folds;
    return folds;
  }

private:
  static constexpr Real touching = 0.15;  // of a side: two surfaces at this distance are one
  static constexpr std::size_t knot = 3;  // sides, where a tip of soil is squeezed against the body

  /// Whether a corner of free ground touches a free side.
  static bool touches(const OutlineLoop& loop, std::size_t corner, std::size_t side)
  {
    const Vec<2>&a = loop.corners[side].x, &b = loop.corners[(side + 1) % loop.corners.size()].x, &x = loop.corners[corner].x;
    const Vec<2> along = b - a;
    const Real part = std::clamp((x - a).dot(along) / along.squaredNorm(), Real(0), Real(1));
    return (a + part * along - x).norm() <
           touching * std::min({length_of(loop, side), length_of(loop, corner), length_of(loop, corner - 1)});
  }

  /// Whether what lies between these corners is no soil, which is on the left of a loop.
  static bool is_void(const OutlineLoop& loop, std::size_t first, std::size_t last)
  {
    Real twice = 0;
    for (std::size_t k = first; k <= last; ++k) {
      const Vec<2> a = loop.corners[k].x - loop.corners[first].x, b = loop.corners[k < last ? k + 1 : first].x - loop.corners[first].x;
      twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice < 0;
  }

  static bool cross(const OutlineLoop& loop, std::size_t first, std::size_t second)
  {
    const auto at = [&](std::size_t k) -> const Vec<2>& { return loop.corners[k % loop.corners.size()].x; };
    const auto turn = [](const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) { return (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]; };
    const Vec<2>&a = at(first), &b = at(first + 1), &c = at(second), &d = at(second + 1);
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

  bool close_one(std::size_t l)
  {
    const OutlineLoop& loop = loops_[l];
    const std::size_t n = loop.corners.size();
    for (std::size_t k = 1; k + 1 < n; ++k) {
      for (std::size_t j = k + 2; j + 1 < n; ++j)
        if ((j <= k + knot || (loop.free[k] && loop.free[j])) && cross(loop, k, j)) return cut(l, k, j + 1);
      if (!loop.free[k - 1] || !loop.free[k]) continue;
      for (std::size_t j = k + 1; j + 1 < n; ++j)
        if (loop.free[j] && touches(loop, k, j) && is_void(loop, k, j + 1)) return cut(l, k, j + 1);
      for (std::size_t j = 1; j + 1 < k; ++j)
        if (loop.free[j] && touches(loop, k, j) && is_void(loop, j, k)) return cut(l, j, k);
    }
    return false;
  }

  /// Makes one side from corner `first` to corner `last` of what lies between; where that meets the body it is a loop of its own.
  bool cut(std::size_t l, std::size_t first, std::size_t last)
  {
    OutlineLoop& loop = loops_[l];
    const auto part = [&](const auto& list) {
      return std::vector(list.begin() + static_cast<std::ptrdiff_t>(first), list.begin() + static_cast<std::ptrdiff_t>(last));
    };
    OutlineLoop between{part(loop.corners), part(loop.middles), part(loop.boundary), part(loop.free)};
    const auto erase = [&](auto& list, std::size_t from) {
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(from), list.begin() + static_cast<std::ptrdiff_t>(last));
    };
    // Not to a corner that is so near that the side would be short.
    if (last + 1 < loop.corners.size() && loop.free[last] && distance(loop, first, last) < length_of(loop, last) / 2) ++last;
    loop.middles[first] = straight(loop, first, last);
    erase(loop.corners, first + 1), erase(loop.middles, first + 1), erase(loop.boundary, first + 1), erase(loop.free, first + 1);
    if (between.corners.size() <= knot + 1 || std::ranges::all_of(between.free, [](char free) { return free != 0; })) return true;
    between.corners.erase(between.corners.begin()), between.middles.erase(between.middles.begin());
    between.boundary.erase(between.boundary.begin()), between.free.erase(between.free.begin());
    between.middles.back() = straight(between, between.corners.size() - 1, 0);
    loops_.push_back(std::move(between));
    return true;
  }

  static OutlinePoint straight(const OutlineLoop& loop, std::size_t from, std::size_t to)
  {
    OutlinePoint middle = loop.corners[from];
    middle.x = (middle.x + loop.corners[to].x) / 2;
    return middle;
  }

  std::vector<OutlineLoop>& loops_;
};

}  // namespace

int close_folds(std::vector<OutlineLoop>& loops)
{
  return FoldCloser(loops).close();
}

}  // namespace berm::fem
