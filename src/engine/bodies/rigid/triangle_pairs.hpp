// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>

namespace berm::bodies {

/// A triangle with its unit normal.
struct Facet {
  std::array<Vec<3>, 3> corners;  ///< m
  Vec<3> normal;
};
Facet facet_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c);

/// How two triangles lie to each other.
enum class Intersection {
  apart,    ///< in corners and edges that they share they may meet
  touch,    ///< along a line, of which an edge of one is a part: whether surfaces pass through each other there their neighbours tell
  cut,      ///< along a line within both
  overlap,  ///< in one plane, over an area
};

/// Of corners that are shared, `shared[k]` is the corner of `other` that corner k of `one` is, or none. What is less than `tolerance`, m, is none.
Intersection intersection_of(const Facet& one, const Facet& other, const std::array<Index, 3>& shared, Real tolerance);

/// Where a line from a point meets a triangle.
struct Hit {
  bool hit = false,
       doubtful = false;  ///< doubtful: it passes an edge so near, or so flat, or begins so near, that another line should be asked
  bool out = false;       ///< it leaves what the triangle bounds
};
Hit hit_of(const Facet& facet, const Vec<3>& start, const Vec<3>& direction, Real tolerance);

}  // namespace berm::bodies
