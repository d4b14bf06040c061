// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>
#include <string>
#include <vector>

namespace berm::plot {

/// Values at the middles of the equal pixels of a rectangle; none where no triangle was painted.
class Raster {
public:
  /// lower and upper: the rectangle's corners, m.
  Raster(const Vec<2>& lower, const Vec<2>& upper, Index columns, Index rows);

  /// Gives the pixels whose middles lie in the triangle what its corners have, linear between them. The corners may go either way round.
  void paint(const std::array<Vec<2>, 3>& corners, const std::array<Real, 3>& values);

  /// The value of a pixel, NaN where there is none; row 0 is the lowest.
  Real at(Index column, Index row) const { return values_[static_cast<std::size_t>(row) * columns_ + column]; }
  /// The bytes of the values as float, row by row from the lowest up, which gnuplot reads ten times faster than text.
  std::string floats() const;

private:
  Vec<2> lower_, pixels_per_metre_;
  Index columns_, rows_;
  std::vector<Real> values_;
};

}  // namespace berm::plot
