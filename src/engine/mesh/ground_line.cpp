// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ground_line.hpp"

#include <algorithm>

namespace berm::mesh {
namespace {

constexpr Real rounding = 1e-7;  // of the length of the line

/// The first corner right of x; its end where there is none.
std::vector<Vec<2>>::const_iterator right_of(const std::vector<Vec<2>>& corners, Real x)
{
  return std::upper_bound(corners.begin(), corners.end(), x, [](Real at, const Vec<2>& corner) { return at < corner[0]; });
}

Real distance_from_segment(const Vec<2>& x, const Vec<2>& from, const Vec<2>& to)
{
  const Vec<2> along = to - from;
  const Real fraction = along.squaredNorm() > 0 ? std::clamp((x - from).dot(along) / along.squaredNorm(), Real(0), Real(1)) : 0;
  return (x - from - fraction * along).norm();
}

}  // namespace

Real GroundLine::height(Real x) const
{
  const auto right = right_of(corners, x);
  if (right == corners.begin()) return corners.front()[1];
  if (right == corners.end()) return corners.back()[1];
  const Vec<2>&a = *(right - 1), &b = *right;
  return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
}

std::pair<Real, Real> GroundLine::heights(Real from, Real to) const
{
  std::pair<Real, Real> range = std::minmax({height(from), height(to)});
  for (const Vec<2>& corner : corners)
    if (corner[0] >= from && corner[0] <= to) {
      range.first = std::min(range.first, corner[1]);
      range.second = std::max(range.second, corner[1]);
    }
  return range;
}

Real GroundLine::distance(const Vec<2>& x) const
{
  Real nearest = (x - corners.front()).norm();
  for (std::size_t k = 1; k < corners.size(); ++k) nearest = std::min(nearest, distance_from_segment(x, corners[k - 1], corners[k]));
  return nearest;
}

GroundLine within(const GroundLine& line, const Vec<2>& lower, const Vec<2>& upper)
{
  GroundLine inside;
  const auto add = [&](const Vec<2>& x) {
    if (inside.corners.empty() || inside.corners.back() != x) inside.corners.push_back(x);
  };
  for (std::size_t k = 1; k < line.corners.size(); ++k) {
    const Vec<2>&a = line.corners[k - 1], &b = line.corners[k];
    Real from = 0, to = 1;  // parts of the way from a to b that lie inside
    for (int d = 0; d < 2; ++d) {
      const Real way = b[d] - a[d];
      if (way == 0 && (a[d] < lower[d] || a[d] > upper[d])) to = -1;
      if (way == 0) continue;
      const auto [enters, leaves] = std::minmax({(lower[d] - a[d]) / way, (upper[d] - a[d]) / way});
      from = std::max(from, enters), to = std::min(to, leaves);
    }
    if (from >= to) continue;
    add(a + from * (b - a));
    add(a + to * (b - a));
  }
  return inside;
}

GroundLine simplified(const GroundLine& line)
{
  if (line.corners.size() < 2) return {};
  const Real margin = rounding * (line.corners.back()[0] - line.corners.front()[0]);
  GroundLine kept;
  for (std::size_t k = 0; k < line.corners.size(); ++k) {
    // What lies between the last corner that stays and this one is left out as long as all of it is on the straight line.
    const bool last = k + 1 == line.corners.size();
    if (!kept.corners.empty() && !last) {
      const Vec<2>&from = kept.corners.back(), &to = line.corners[k + 1];
      bool straight = true;
      for (std::size_t j = k; straight && j > 0 && line.corners[j] != from; --j)
        straight = distance_from_segment(line.corners[j], from, to) <= margin;
      if (straight) continue;
    }
    kept.corners.push_back(line.corners[k]);
  }
  const auto [low, high] =
      std::minmax_element(kept.corners.begin(), kept.corners.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  if ((*high)[1] - (*low)[1] <= margin) return {};
  return kept;
}

}  // namespace berm::mesh
