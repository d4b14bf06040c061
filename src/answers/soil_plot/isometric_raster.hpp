// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "soil_plot/raster.hpp"

#include <string>
#include <vector>

namespace berm::soil_plot {

/// An isometric picture in pixels of what lies in a box: each pixel has the colour of what is nearest to the eye there, white where nothing is.
class IsometricRaster {
public:
  /// lower and upper: the box, m; columns: pixels of the picture's width, from which its rows follow.
  IsometricRaster(const Vec<3>& lower, const Vec<3>& upper, Index columns);

  Index columns() const { return columns_; }
  Index rows() const { return rows_; }
  Real pixels_per_metre() const { return pixels_per_metre_; }

  /// A ball, lit from above and left, where its centre lies in the box. radius: m.
  void paint_ball(const Vec<3>& center, Real radius, const Rgb& color);
  /// The part of a triangle in the box, lit by its direction; its corners may go either way round.
  void paint_triangle(const std::array<Vec<3>, 3>& corners, const Rgb& color);

  /// Red, green and blue of a pixel; row 0 is the lowest.
  std::array<int, 3> at(Index column, Index row) const;
  /// Three bytes a pixel, row by row from the lowest up.
  std::string bytes() const;

private:
  bool holds(const Vec<3>& x) const;
  Vec<2> pixel_of(const Vec<3>& x) const;
  void paint(Index column, Index row, Real depth, Real light, const Rgb& color);

  Vec<3> lower_, upper_;
  Index columns_, rows_;
  Vec<2> left_below_;  ///< m in the picture
  Real pixels_per_metre_;
  std::vector<Real> depth_;  ///< m towards the eye
  std::vector<unsigned char> colors_;
};

}  // namespace berm::soil_plot
