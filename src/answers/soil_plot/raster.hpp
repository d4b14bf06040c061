// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace berm::soil_plot {

/// Values at the middles of the equal pixels of a rectangle; none where nothing was painted.
class Raster {
public:
  /// lower and upper: the rectangle's corners, m.
  Raster(const Vec<2>& lower, const Vec<2>& upper, Index columns, Index rows);

  /// Gives the pixels whose middles lie in the triangle what its corners have, linear between them. The corners may go either way round.
  void paint(const std::array<Vec<2>, 3>& corners, const std::array<Real, 3>& values);

  /// Gives the pixels whose middles lie in the ellipse x = center + A c, |c| <= 1, a value, but for those that lie nearer to the center of another one, as their |c| tells.
  void paint_ellipse(const Vec<2>& center, const Matrix<2>& A, Real value);

  /// The value of a pixel, NaN where there is none; row 0 is the lowest.
  Real at(Index column, Index row) const { return values_[static_cast<std::size_t>(row) * columns_ + column]; }
  /// The bytes of the values as float, row by row from the lowest up, which gnuplot reads ten times faster than text.
  std::string floats() const;

private:
  Vec<2> lower_, pixels_per_metre_;
  Index columns_, rows_;
  std::vector<Real> values_;
  std::vector<Real> nearest_;  ///< least |c|^2 of ellipses, by pixel
};

/// Where a point is in an isometric picture, seen from the positive side of all axes with y up: m to the right and m up.
inline Vec<2> isometric(const Vec<3>& x)
{
  return {(x[0] - x[2]) / std::sqrt(2.), (2 * x[1] - x[0] - x[2]) / std::sqrt(6.)};
}

/// How far a point is towards the eye of that picture, m.
inline Real towards_eye(const Vec<3>& x)
{
  return x.sum() / std::sqrt(3.);
}

/// Red, green and blue, 0 to 255.
using Rgb = std::array<Real, 3>;

/// The colour at a part from 0 to 1 of viridis, which is even to the eye and in grey; the nearest end beyond them.
Rgb viridis(Real part);

/// The command of gnuplot that makes these colours its palette.
std::string viridis_palette();

/// Where the colours of values begin and end: at zero, and beyond it where one value in a hundred lies farther; at the farthest where all but those are
/// zero. There must be a value.
std::pair<Real, Real> color_range(std::vector<Real> values);

}  // namespace berm::soil_plot
