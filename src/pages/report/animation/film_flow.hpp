// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_quantization.hpp"

#include <optional>

namespace berm::report {

/// The flow of the water as arrows on a grid of squares: in each the mean of the fluxes of the points that are in it.
struct FilmFlow {
  FilmBox box;    ///< m, what the squares cover
  Real side = 0;  ///< m, of a square
  Index columns = 0, rows = 0;
  std::vector<Real> largest;       ///< m/s, the largest component of a frame, which 127 stands for
  std::vector<std::int8_t> codes;  ///< x, y of each square, row by row from below, frame by frame; 0, 0 where less than half of it is soil
};

/// The arrows of these frames over a view; none where the frames have no flow, or none that is not zero. `sizes`: m, by point.
std::optional<FilmFlow> film_flow(const std::vector<const FilmFrame*>& frames, const std::vector<float>& sizes, const FilmBox& view);

}  // namespace berm::report
