// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_test.cpp
#include "bodies/rigid/triangle_mesh.hpp"

#include "bodies/rigid/triangle_boxes.hpp"
#include "os/interrupt.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <unordered_map>

namespace berm::bodies {
namespace {

constexpr int face = 6;

}  // namespace

/// The triangles of a mesh in boxes within boxes.
struct TriangleTree {
  TriangleBoxes boxes;
  mutable std::vector<Index> starts;  ///< by cell of the grid: a triangle that is near, whose distance a search begins with

  explicit TriangleTree(const Triangles& t) : boxes(boxes_of(t)) {}
};

Contents contents_of(const Triangles& t)
{
  // From one of its points, so that no digits are lost far from the origin.
  const Vec<3> origin = t.points.front();
  Real volume = 0;
  Vec<3> first = Vec<3>::Zero();
  Matrix<3> second = Matrix<3>::Zero();
  for (const auto& [i, j, k] : t.corners) {
    const Vec<3> a = t.points[i] - origin, b = t.points[j] - origin, c = t.points[k] - origin, sum = a + b + c;
    const Real part = a.dot(b.cross(c)) / 6;
    volume += part;
    first += part / 4 * sum;
    second += part / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  const Vec<3> center = first / volume;
  const Matrix<3> squares = second / volume - center * center.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix<3>> principal(Matrix<3>::Identity() * squares.trace() - squares);
  Matrix<3> axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return {volume, origin + center, principal.eigenvalues(), axes};
}

TriangleMesh::TriangleMesh(Triangles triangles) : triangles_(std::move(triangles)), tree_(std::make_unique<TriangleTree>(triangles_))
{
  const std::size_t count = triangles_.corners.size();
  for (std::vector<Vec<3>>& of_feature : normals_) of_feature.assign(count, Vec<3>::Zero());
  std::vector<Vec<3>> of_point(triangles_.points.size(), Vec<3>(Vec<3>::Zero()));
  std::unordered_map<std::uint64_t, Vec<3>> of_edge;
  of_edge.reserve(count * 3 / 2);
  const auto edge = [&](std::size_t t, int opposite) {
    const auto& corners = triangles_.corners[t];
    const auto [one, other] = std::minmax({corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]});
    return (static_cast<std::uint64_t>(one) << 32) | static_cast<std::uint64_t>(other);
  };
  for (std::size_t t = 0; t < count; ++t) {
    const auto& corners = triangles_.corners[t];
    const auto at = [&](int k) -> const Vec<3>& { return triangles_.points[corners[k % 3]]; };
    const Vec<3> normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    normals_[face][t] = normal;
    for (int k = 0; k < 3; ++k) {
      const Vec<3> a = at(k + 1) - at(k), b = at(k + 2) - at(k);
      of_point[corners[k]] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
      const auto found = of_edge.try_emplace(edge(t, k), Vec<3>(Vec<3>::Zero())).first;
      found->second += normal;
    }
  }
  for (std::size_t t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) {
      normals_[k][t] = of_point[triangles_.corners[t][k]].normalized();
      normals_[3 + k][t] = of_edge.at(edge(t, k)).normalized();
    }
  for (const Vec<3>& x : triangles_.points) reach_ = std::max(reach_, x.norm());
  list_candidates();
}

TriangleMesh::TriangleMesh(TriangleMesh&&) noexcept = default;
TriangleMesh::~TriangleMesh() = default;

/// The point of a triangle nearest to x, by the regions around it (Ericson 2005, section 5.1.5).
TriangleMesh::Nearest TriangleMesh::on_triangle(const Vec<3>& x, Index triangle) const
{
  const auto& [i, j, k] = triangles_.corners[triangle];
  const Vec<3>&a = triangles_.points[i], &b = triangles_.points[j], &c = triangles_.points[k];
  const auto found = [&](const Vec<3>& nearest, int feature) {
    const Vec<3> from = x - nearest;
    return Nearest{from.squaredNorm(), from, triangle, feature};
  };
  const Vec<3> ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const Real d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return found(a, 0);
  const Real d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return found(b, 1);
  const Real vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return found(a + d1 / (d1 - d3) * ab, 5);
  const Real d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return found(c, 2);
  const Real vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return found(a + d2 / (d2 - d6) * ac, 4);
  const Real va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return found(b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 3);
  return found(a + (vb * ab + vc * ac) / (va + vb + vc), face);
}

TriangleMesh::Nearest TriangleMesh::by_tree(const Vec<3>& x) const
{
  // A box that is farther than what is found so far is left out; the search begins with a triangle that is near.
  struct Search {
    const TriangleMesh& mesh;
    const Vec<3>& x;
    Nearest nearest;

    bool intersectVolume(const AlignedBox& box) const { return box.squaredExteriorDistance(x) < nearest.square; }
    bool intersectObject(Index triangle)
    {
      if (const Nearest here = mesh.on_triangle(x, triangle); here.square < nearest.square) nearest = here;
      return false;
    }
  };
  Vec<3> at = (x - lower_) / cell_;
  for (int d = 0; d < 3; ++d) at[d] = std::clamp(at[d], Real(0), Real(cells_[d]) - Real(0.5));
  const Index cell = (static_cast<Index>(at[2]) * cells_[1] + static_cast<Index>(at[1])) * cells_[0] + static_cast<Index>(at[0]);
  Search search{*this, x, on_triangle(x, tree_->starts[cell])};
  Eigen::BVIntersect(tree_->boxes, search);
  return search.nearest;
}

void TriangleMesh::list_candidates()
{
  constexpr Real cells = 64;       // along the longest side
  constexpr Real margin = 0.1;     // of that
  constexpr std::size_t max = 64;  // more are found faster by the tree
  AlignedBox box;
  for (const Vec<3>& x : triangles_.points) box.extend(x);
  const Real longest = box.sizes().maxCoeff();
  cell_ = longest * (1 + 2 * margin) / cells;
  lower_ = box.min() - Vec<3>::Constant(margin * longest);
  for (int d = 0; d < 3; ++d) cells_[d] = static_cast<Index>(std::ceil((box.sizes()[d] + 2 * margin * longest) / cell_));

  struct Collector {
    const TriangleMesh& mesh;
    Vec<3> x;
    Real square;
    std::vector<Index>& found;

    bool intersectVolume(const AlignedBox& volume) const { return volume.squaredExteriorDistance(x) <= square; }
    bool intersectObject(Index triangle)
    {
      if (mesh.on_triangle(x, triangle).square <= square) found.push_back(triangle);
      return found.size() > max;
    }
  };
  // The triangle nearest to a point of a cell is at most a diagonal farther from the cell's centre than the one nearest to that.
  // Cells far from the surface have no list: what lies there is in no contact.
  constexpr Real band = 6;  // cells
  tree_->starts.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], 0);
  Index before = 0;
  const Real diagonal = 1.0001 * std::sqrt(3.) * cell_;
  std::vector<Index> found;
  first_.push_back(0);
  for (Index k = 0; k < cells_[2]; ++k)
    for (Index j = 0; j < cells_[1]; ++j)
      for (Index i = 0; i < cells_[0]; ++i) {
        stop_if_asked("distances from a surface were prepared");
        const Vec<3> center = lower_ + cell_ * Vec<3>(i + 0.5, j + 0.5, k + 0.5);
        Index& start = tree_->starts[first_.size() - 1];
        start = before;
        const Nearest nearest = by_tree(center);
        start = before = nearest.triangle;
        const Real reach = std::sqrt(nearest.square) + diagonal;
        found.clear();
        Collector collector{*this, center, reach * reach, found};
        if (reach < band * cell_) Eigen::BVIntersect(tree_->boxes, collector);
        if (found.size() <= max) candidates_.insert(candidates_.end(), found.begin(), found.end());
        first_.push_back(static_cast<Index>(candidates_.size()));
      }
}

SurfacePoint<3> TriangleMesh::surface_at(const Vec<3>& x) const
{
  const Vec<3> at = (x - lower_) / cell_;
  Nearest nearest;
  if (at.minCoeff() >= 0 && at[0] < cells_[0] && at[1] < cells_[1] && at[2] < cells_[2]) {
    const Index cell = (static_cast<Index>(at[2]) * cells_[1] + static_cast<Index>(at[1])) * cells_[0] + static_cast<Index>(at[0]);
    for (Index k = first_[cell]; k < first_[cell + 1]; ++k)
      if (const Nearest here = on_triangle(x, candidates_[k]); here.square < nearest.square) nearest = here;
  }
  if (nearest.triangle == none) nearest = by_tree(x);
  const Vec<3>& normal = normals_[nearest.feature][nearest.triangle];
  const Real distance = std::sqrt(nearest.square);
  constexpr Real on_it = 1e-12;  // of its size: no direction is left in the difference
  if (distance <= on_it * reach_) return {0, normal};
  const bool inside = nearest.from.dot(normal) < 0;
  if (nearest.feature == face) return {inside ? -distance : distance, normal};
  return {inside ? -distance : distance, nearest.from / (inside ? -distance : distance)};
}

}  // namespace berm::bodies
