// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_test.cpp
#include "bodies/rigid/triangle_faults.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <unordered_map>

namespace berm::bodies {
namespace {

std::string words_of(const Vec<3>& x)
{
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
}

/// Counts one kind of fault, and where the first is.
struct Fault {
  Index count = 0;
  Vec<3> first = Vec<3>::Zero();

  void add(const Vec<3>& x)
  {
    if (count++ == 0) first = x;
  }
  std::string words(const char* one, const char* many) const
  {
    return count == 0 ? std::string() : fmt::format("{} {}, such as at {}", count, count == 1 ? one : many, words_of(first));
  }
};

Vec<3> middle_of(const Triangles& t, const std::array<Index, 3>& corners)
{
  return (t.points[corners[0]] + t.points[corners[1]] + t.points[corners[2]]) / 3;
}

std::string faults_of_edges(const Triangles& t)
{
  struct Edge {
    Index there = 0, back = 0;
  };
  std::unordered_map<std::uint64_t, Edge> edges;
  const auto key = [](Index a, Index b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b));
  };
  for (const auto& corners : t.corners)
    for (int k = 0; k < 3; ++k) {
      const Index a = corners[k], b = corners[(k + 1) % 3];
      Edge& edge = edges[key(a, b)];
      ++(a < b ? edge.there : edge.back);
    }
  Fault open, many, turned;
  for (const auto& corners : t.corners)
    for (int k = 0; k < 3; ++k) {
      const Index a = corners[k], b = corners[(k + 1) % 3];
      Edge& edge = edges[key(a, b)];
      const Vec<3> middle = (t.points[a] + t.points[b]) / 2;
      const Index count = edge.there + edge.back;
      if (count == 1) open.add(middle);
      if (count > 2) many.add(middle);
      if (count == 2 && edge.there != edge.back) turned.add(middle);
      edge = {1, 1};  // said once
    }
  if (open.count > 0) return "is not closed: " + open.words("edge with one triangle", "edges with one triangle");
  if (many.count > 0) return many.words("edge with more than two triangles", "edges with more than two triangles");
  return turned.count > 0 ? turned.words("edge between triangles of opposite directions", "edges between triangles of opposite directions")
                          : std::string();
}

/// Whether the side from p to q cuts through a triangle, by the signs of the volumes of the tetrahedra that they make.
bool cuts(const Vec<3>& p, const Vec<3>& q, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c)
{
  const auto volume = [](const Vec<3>& o, const Vec<3>& i, const Vec<3>& j, const Vec<3>& k) { return (i - o).dot((j - o).cross(k - o)); };
  if (volume(p, a, b, c) * volume(q, a, b, c) >= 0) return false;
  const Real one = volume(p, q, a, b), two = volume(p, q, b, c), three = volume(p, q, c, a);
  return (one > 0 && two > 0 && three > 0) || (one < 0 && two < 0 && three < 0);
}

bool cut_each_other(const Triangles& t, const std::array<Index, 3>& one, const std::array<Index, 3>& other)
{
  const auto crosses = [&](const std::array<Index, 3>& sides, const std::array<Index, 3>& through) {
    for (int k = 0; k < 3; ++k) {
      const Index p = sides[k], q = sides[(k + 1) % 3];
      const auto has = [&](Index point) { return std::find(through.begin(), through.end(), point) != through.end(); };
      if (!has(p) && !has(q) && cuts(t.points[p], t.points[q], t.points[through[0]], t.points[through[1]], t.points[through[2]]))
        return true;
    }
    return false;
  };
  return crosses(one, other) || crosses(other, one);
}

/// The triangles that cut through others, found among those whose boxes overlap in a sweep along x.
Fault cuts_of(const Triangles& t)
{
  using Box = Eigen::AlignedBox<Real, 3>;
  std::vector<Box> boxes;
  for (const auto& [a, b, c] : t.corners) {
    Box box(t.points[a]);
    boxes.push_back(box.extend(t.points[b]).extend(t.points[c]));
  }
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return boxes[a].min()[0] < boxes[b].min()[0]; });
  Fault fault;
  for (std::size_t m = 0; m < order.size(); ++m)
    for (std::size_t n = m + 1; n < order.size() && boxes[order[n]].min()[0] <= boxes[order[m]].max()[0]; ++n)
      if (boxes[order[m]].intersects(boxes[order[n]]) && cut_each_other(t, t.corners[order[m]], t.corners[order[n]]))
        fault.add(middle_of(t, t.corners[order[m]]));
  return fault;
}

}  // namespace

std::string fault_of(const Triangles& t)
{
  if (t.corners.empty()) return "has no triangle";
  Real size = 0;
  Fault not_finite;
  for (const Vec<3>& x : t.points) {
    if (!x.allFinite()) not_finite.add(x);
    size = std::max(size, (x - t.points.front()).norm());
  }
  if (not_finite.count > 0) return "has points that are no numbers";
  if (size == 0) return "has no size: all its points are one";
  constexpr Real flat = 1e-12;  // of the square of the size: less is round-off
  Fault degenerate;
  for (const auto& corners : t.corners) {
    const Vec<3>&a = t.points[corners[0]], &b = t.points[corners[1]], &c = t.points[corners[2]];
    if ((b - a).cross(c - a).norm() <= flat * size * size) degenerate.add(middle_of(t, corners));
  }
  if (degenerate.count > 0) return degenerate.words("triangle without area", "triangles without area");
  if (const std::string faults = faults_of_edges(t); !faults.empty()) return faults;
  if (std::abs(contents_of(t).volume) <= flat * size * size * size) return "contains no volume";
  return cuts_of(t).words("pair of triangles that cut through each other", "pairs of triangles that cut through each other");
}

}  // namespace berm::bodies
