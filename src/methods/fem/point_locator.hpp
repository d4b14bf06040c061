// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/quadratic_mesh.hpp"

namespace berm::fem {

/// The point at (r, s) of a triangle with these nodes, m.
Vec<2> place_in(const AtSixNodes<Vec<2>>& nodes, const Vec<2>& at);

/// The point of the reference triangle that lies at x; where x is outside, one on its rim near it.
Vec<2> nearest_in(const AtSixNodes<Vec<2>>& nodes, const Vec<2>& x);

/// What the integration points contribute to the value at (r, s) of a field that is linear in the element: one at one of them and zero at the two others.
std::array<Real, triangle_points> linear_weights(const Vec<2>& at);

/// A point of a mesh: its element, and where in the reference triangle.
struct MeshPoint {
  Index cell = none;
  Vec<2> at = Vec<2>::Zero();
};

/// Finds points in a mesh whose nodes lie at `position` (m). Both must outlive it.
class PointLocator {
public:
  PointLocator(const QuadraticMesh& mesh, const NodeField<Vec<2>>& position);

  /// The element that contains x; where none does, the point nearest to x that was found around it.
  MeshPoint find(const Vec<2>& x) const;

  AtSixNodes<Vec<2>> nodes_of(Index cell) const;

private:
  std::array<Index, 2> bin_of(const Vec<2>& x) const;

  const QuadraticMesh& mesh_;
  const NodeField<Vec<2>>& position_;
  Vec<2> lower_, bin_size_;
  std::array<Index, 2> bins_;
  std::vector<std::vector<Index>> cells_;  ///< by bin, row by row: those whose bounding box meets it
};

}  // namespace berm::fem
