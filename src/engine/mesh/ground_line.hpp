// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::mesh {

/// The surface of a bed that is not level, as a line of corners from left to right, m; without corners it is level, at a height that is known elsewhere. At a
/// vertical face two corners have one x.
struct GroundLine {
  std::vector<Vec<2>> corners;

  bool level() const { return corners.empty(); }
  /// y of the surface at x (of the part right of a corner); beyond the ends it goes on level. The line must have corners.
  Real height(Real x) const;
  /// The lowest and the highest y from x to x.
  std::pair<Real, Real> heights(Real from, Real to) const;
  /// Distance of a point from the line, m.
  Real distance(const Vec<2>& x) const;
};

/// The parts of the line inside a rectangle, as one line: what leaves it through the bottom or the top is cut there.
GroundLine within(const GroundLine& line, const Vec<2>& lower, const Vec<2>& upper);

/// The same line without corners that lie on the straight line between their neighbours, to round-off; without any where it is level.
GroundLine simplified(const GroundLine& line);

}  // namespace berm::mesh
