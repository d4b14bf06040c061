// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_test.cpp
#include "bodies/rigid/triangle_faults.hpp"

#include "bodies/rigid/fault_count.hpp"
#include "bodies/rigid/surface_overlaps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

namespace berm::bodies {
namespace {

/// Connected sets of triangles, by shared edges.
class Surfaces {
public:
  explicit Surfaces(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }

  void join(Index one, Index other)
  {
    const Index a = first_of(one), b = first_of(other);
    above_[std::max(a, b)] = std::min(a, b);
  }
  Index first_of(Index triangle)
  {
    while (above_[triangle] != triangle) triangle = above_[triangle] = above_[above_[triangle]];
    return triangle;
  }

private:
  std::vector<Index> above_;
};

std::string faults_of_edges(const Triangles& t, Surfaces& surfaces)
{
  struct Edge {
    Index there = 0, back = 0, triangle = none;
  };
  std::unordered_map<std::uint64_t, Edge> edges;
  edges.reserve(t.corners.size() * 3 / 2);
  const auto key = [](Index a, Index b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint64_t>(std::max(a, b));
  };
  for (Index n = 0; n < static_cast<Index>(t.corners.size()); ++n)
    for (int k = 0; k < 3; ++k) {
      const Index a = t.corners[n][k], b = t.corners[n][(k + 1) % 3];
      Edge& edge = edges[key(a, b)];
      ++(a < b ? edge.there : edge.back);
      if (edge.triangle == none) edge.triangle = n;
      surfaces.join(n, edge.triangle);
    }
  FaultCount open, many, turned;
  for (const auto& corners : t.corners)
    for (int k = 0; k < 3; ++k) {
      const Index a = corners[k], b = corners[(k + 1) % 3];
      Edge& edge = edges[key(a, b)];
      const Vec<3> middle = (t.points[a] + t.points[b]) / 2;
      const Index count = edge.there + edge.back;
      if (count == 1) open.add(middle);
      if (count > 2) many.add(middle);
      if (count == 2 && edge.there != edge.back) turned.add(middle);
      edge.there = edge.back = 1;  // said once
    }
  if (open.count > 0) return "is not closed: " + open.words("edge with one triangle", "edges with one triangle");
  if (many.count > 0) return many.words("edge with more than two triangles", "edges with more than two triangles");
  return turned.words("edge between triangles of opposite directions", "edges between triangles of opposite directions");
}

}  // namespace

std::string fault_of(const Triangles& t)
{
  if (t.corners.empty()) return "has no triangle";
  Real size = 0;
  FaultCount not_finite;
  for (const Vec<3>& x : t.points) {
    if (!x.allFinite()) not_finite.add(x);
    size = std::max(size, (x - t.points.front()).norm());
  }
  if (not_finite.count > 0) return "has points that are not numbers";
  if (size == 0) return "has no size: all its points are one";
  if (!std::isfinite(size * size * size * size * size)) return "is too large for its volume and moments of inertia to be numbers";
  constexpr Real flat = 1e-12;  // of the square of the size: less is round-off
  FaultCount degenerate;
  for (const auto& corners : t.corners) {
    const Vec<3>&a = t.points[corners[0]], &b = t.points[corners[1]], &c = t.points[corners[2]];
    if ((b - a).cross(c - a).norm() <= flat * size * size) degenerate.add((a + b + c) / 3);
  }
  if (degenerate.count > 0) return degenerate.words("triangle without area", "triangles without area");
  Surfaces surfaces(t.corners.size());
  if (const std::string faults = faults_of_edges(t, surfaces); !faults.empty()) return faults;
  if (std::abs(contents_of(t).volume) <= flat * size * size * size) return "contains no volume";
  std::vector<Index> surface_of(t.corners.size());
  for (Index n = 0; n < static_cast<Index>(surface_of.size()); ++n) surface_of[n] = surfaces.first_of(n);
  return overlaps_of(t, surface_of, size);
}

}  // namespace berm::bodies
