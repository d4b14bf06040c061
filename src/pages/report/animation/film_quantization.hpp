// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_fields.hpp"

namespace berm::report {

/// Numbers as they lie in memory: little-endian.
template <class T>
std::string bytes_of(const std::vector<T>& numbers)
{
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

/// The largest code of a place.
constexpr Real max_code = 65535;

/// A rectangle, m.
struct FilmBox {
  Vec<2> lower, upper;
};

/// The lowest and the highest of lists of numbers; infinity and -infinity of none.
std::pair<Real, Real> ends_of(const std::vector<const std::vector<Real>*>& lists);

/// The box of all points in all frames.
FilmBox box_of(const std::vector<const FilmFrame*>& frames);

/// Places as whole numbers from 0 to 65535: x = lower + step * code in both directions.
struct FilmGrid {
  Vec<2> lower;  ///< m
  Real step;     ///< m
  explicit FilmGrid(const FilmBox& box);
  std::uint16_t code(Real x, int d) const;
};

/// Places along one axis, by frame, as codes: bytes [low][high], each by frame, then point. Those of frame 0 as they are, of each later one the change since the
/// frame before, folded: 0, -1, 1, -2, ... are 0, 1, 2, 3, ...
std::string axis_bytes(const std::vector<const std::vector<Real>*>& frames, Real lower, Real step);

/// The codes of all places, x and then y and, where there is one, z from `lower_z` on, as bytes of the position block of FilmData in web/src/data.ts.
std::string position_bytes(const std::vector<const FilmFrame*>& frames, const FilmGrid& grid, Real lower_z = 0);

/// Sides of squares (m) in the grid's steps, at least one, as bytes of 16-bit numbers.
std::string size_bytes(const std::vector<float>& sizes, const FilmGrid& grid);

/// Each quadratic triangle as four, between its corners and the middles of its sides, as bytes of 32-bit numbers.
constexpr int parts_of_triangle = 4;
std::string triangle_bytes(const std::vector<std::array<Index, 6>>& triangles);

/// What the bytes 0 and 255 of a field stand for.
struct FilmRange {
  Real low = 0, high = 1;
};

/// The range of a field: from 0 to what 0.2 % of the values exceed, rounded up, or to the largest where that is not above 0; to the other side in the same way.
FilmRange range_of(std::vector<float> values);

/// Values (by frame, then point) as bytes of a field's block.
std::string field_bytes(const std::vector<float>& values, std::size_t count, const FilmRange& range);

}  // namespace berm::report
