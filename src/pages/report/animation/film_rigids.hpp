// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_fields.hpp"

namespace berm::report {

/// A closed polygon or a line of a rigid body, as it moves.
struct FilmOutline {
  std::int32_t rigid;         ///< number of the rigid body
  Index points;               ///< corners
  std::vector<Real> corners;  ///< x, y (m) of each by frame; NaN in frames where it is not there
};

/// The outlines of all rigid bodies: in plane strain of each of their polygons and lines, in space of the end of those that are extruded along z.
std::vector<FilmOutline> film_outlines(const std::vector<const FilmFrame*>& frames, int dimension);

/// Its corners from a place, as bytes of a block of RigidData in web/src/data.ts: single precision, which the film's own corner leaves enough digits.
std::string outline_bytes(const FilmOutline& outline, const Vec<2>& from);

/// The surface of a rigid body in space, as it moves.
struct FilmSurface {
  std::int32_t rigid;                                     ///< number of the rigid body
  Index points;                                           ///< corners
  std::vector<std::uint32_t> triangles;                   ///< corners, three each
  std::vector<std::array<std::vector<Real>, 3>> corners;  ///< x, y, z (m) by frame; in a frame without them those of the frame before
};

/// The surfaces of all rigid bodies; of polygons, quadrilaterals and hexahedra the triangles that they consist of.
std::vector<FilmSurface> film_surfaces(const std::vector<const FilmFrame*>& frames);

/// Corners of a surface as codes from 0 to 65535: x = lower + step * code.
struct SurfaceGrid {
  Vec<3> lower;  ///< m
  Real step;     ///< m
  explicit SurfaceGrid(const FilmSurface& surface);
  /// Of all corners, x, then y, then z.
  std::string bytes(const FilmSurface& surface) const;
};

}  // namespace berm::report
