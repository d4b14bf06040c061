// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// The size of elements in large deformations, m: `contact` up to a quarter of the width of the narrowest body from the surface of the nearest, growing from there to `largest`; half of it at the edges of the contact, a quarter at the corners of bodies.
struct ElementSizes {
  Real contact, largest, fine;  ///< fine: m from a body
  static constexpr Real growth = 0.1;
  static constexpr Real at_edge = 0.5, at_corner = 0.25;  ///< over `contact`
  static constexpr Real from_there = 0.25;                ///< growth with the distance from edge or corner

  /// At a distance from the nearest body.
  Real at(Real distance) const { return std::min(largest, contact + growth * std::max(Real(0), std::abs(distance) - fine)); }
  /// Of sides of the outline, also at distances from the nearest edge of the contact and corner of a body.
  Real of_side(Real distance, Real from_edge, Real from_corner) const
  {
    return std::min({at(distance), at_edge * contact + from_there * from_edge, at_corner * contact + from_there * from_corner});
  }
};

/// A point of the outline of the soil: where it is, and on which side of the mesh at which part of it, 0 to 1.
struct OutlinePoint {
  Vec<2> x;
  std::size_t side;
  Real part;
};

/// A side of the outline: its first corner, its middle, and its boundary (BoundarySide::boundary).
struct OutlineSide {
  OutlinePoint corner, middle;
  Index boundary;
  bool free;  ///< ground that touches no body
};

/// A closed line with the soil on its left; a side ends where the next begins.
using OutlineLoop = std::vector<OutlineSide>;

/// Puts the middle of a side between its ends.
void straighten(OutlineLoop& loop, std::size_t side);

/// Whether each node is in contact with a rigid body: pressed onto it, or bonded.
NodeField<char> nodes_in_contact(const FemModel& model, const FemState& state);

/// m2, of the polygon of the corners; negative around a void.
Real area_within(const OutlineLoop& loop);

/// The left or the right end of the soil where a vertical boundary holds it across, or the axis; it goes on above the soil. Where it is (m), whether the soil lies at larger x (1) or smaller (-1), and its boundary: the highest one there.
struct Wall {
  Real x, inwards;
  Index boundary;
};

/// The walls of the present stage.
std::vector<Wall> walls_of(const FemModel& model, const FemState& state);

/// Whether ground that is not in contact with a body has gone beyond a wall.
bool is_beyond_wall(const FemModel& model, const FemState& state);

/// Joins ground to the walls that it has come to: corners beyond a wall or at it are put onto it, and sides between two of these become sides of its boundary. What is still open below such a place stays open. Gives the number of new places.
int join_walls(std::vector<OutlineLoop>& loops, const std::vector<Wall>& walls);

/// Joins soil to soil where a loop meets itself at free sides, or comes as near as a part of a side: what lies between is taken as filled, but for a hole around a body. Gives the number of such places.
int close_folds(std::vector<OutlineLoop>& loops);

/// The outline of the soil as it now is, divided anew: its sides are parts of the curved sides of the mesh; ends of the contact, kinks and corners between boundaries stay. What touches a body lies on its
/// exact surface, what does not lies outside of all. Where soil has folded onto soil the two are one, as it is with a wall that soil has come to, and `folds` counts it. The first loop is the outer one.
std::vector<OutlineLoop> divide_outline(const FemModel& model, const FemState& state, const ElementSizes& sizes, int& folds);

}  // namespace berm::fem
