// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/surface.hpp"
#include "core/types.hpp"

#include <array>
#include <memory>
#include <vector>

namespace berm::bodies {

/// Triangles as a file has them.
struct Triangles {
  std::vector<Vec<3>> points;                 ///< m
  std::vector<std::array<Index, 3>> corners;  ///< counter-clockwise seen from outside
};

/// Volume (m3), centre (m), and moments of inertia per mass (m2) about the centre and the axes, the columns (right-handed), of what closed triangles contain: sums
/// over the tetrahedra between the triangles and a point.
struct Contents {
  Real volume;
  Vec<3> center, inertia;
  Matrix<3> axes;
};
Contents contents_of(const Triangles& triangles);

struct TriangleTree;

/// A closed surface of triangles with exact signed distances: the nearest triangle is looked for among those that a cell of a grid lists, or with Eigen's tree of
/// boxes where the grid has no list. The sign is that of the angle-weighted normal of the nearest face, edge or corner (Baerentzen and Aanaes 2005).
class TriangleMesh {
public:
  /// Of triangles that are closed (checked by fault_of).
  explicit TriangleMesh(Triangles triangles);
  TriangleMesh(TriangleMesh&&) noexcept;
  ~TriangleMesh();

  SurfacePoint<3> surface_at(const Vec<3>& x) const;
  const Triangles& triangles() const { return triangles_; }
  Real reach() const { return reach_; }  ///< m, of its points from the origin

private:
  struct Nearest {
    Real square = infinity;        ///< m2, of the distance
    Vec<3> from = Vec<3>::Zero();  ///< m, from the nearest point to x
    Index triangle = none;
    int feature = 0;  ///< 0 to 2 a corner, 3 to 5 the edge opposite to corner 0 to 2, 6 the face
  };
  Nearest on_triangle(const Vec<3>& x, Index triangle) const;
  Nearest by_tree(const Vec<3>& x) const;
  void list_candidates();

  Triangles triangles_;
  std::array<std::vector<Vec<3>>, 7> normals_;  ///< by triangle: of its three corners, the three edges opposite to them, its face
  Real reach_ = 0;
  std::unique_ptr<const TriangleTree> tree_;
  Vec<3> lower_ = Vec<3>::Zero();  ///< of the grid
  Real cell_ = 1;                  ///< m, edge of its cells
  std::array<Index, 3> cells_{};
  std::vector<Index> first_, candidates_;  ///< of each cell; none where it has too many
};

}  // namespace berm::bodies
