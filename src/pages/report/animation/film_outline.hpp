// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_fields_of_frames.hpp"

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

}  // namespace berm::report
