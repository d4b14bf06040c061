// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// The size of elements in large deformations, m: `contact` up to a quarter of the body's width from its surface, growing from there to `largest`; half of it at the edges of the contact.
struct ElementSizes {
  Real contact, largest, fine;  ///< fine: m from the body
  static constexpr Real growth = 0.1;

  /// At a distance from the body.
  Real at(Real distance) const { return std::min(largest, contact + growth * std::max(Real(0), std::abs(distance) - fine)); }
  /// Of sides of the outline, also at a distance from the nearest edge of the contact.
  Real of_side(Real distance, Real from_edge) const { return std::min(at(distance), contact / 2 + from_edge / 4); }
};

/// A point of the outline of the soil: where it is, and on which side of the mesh at which part of it, 0 to 1.
struct OutlinePoint {
  Vec<2> x;
  std::size_t side;
  Real part;
};

/// A closed line with the soil on its left: middle k and boundary k (BoundarySide::boundary) are those of the side from corner k to the next.
struct OutlineLoop {
  std::vector<OutlinePoint> corners, middles;
  std::vector<Index> boundary;
};

/// The outline of the soil as it now is, divided anew: its sides are parts of the curved sides of the mesh; ends of the contact, kinks and corners between boundaries stay. What touches the body lies on its
/// exact surface, what does not lies outside of it. The first loop is the outer one.
std::vector<OutlineLoop> divide_outline(const FemModel& model, const FemState& state, const ElementSizes& sizes);

}  // namespace berm::fem
