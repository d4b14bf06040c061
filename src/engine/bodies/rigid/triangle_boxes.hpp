// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/triangle_mesh.hpp"

#include <Eigen/Geometry>
#include <numeric>
#include <unsupported/Eigen/BVH>

namespace berm::bodies {

using AlignedBox = Eigen::AlignedBox<Real, 3>;

/// The triangles by number, in boxes within boxes.
using TriangleBoxes = Eigen::KdBVH<Real, 3, Index>;

inline AlignedBox box_of(const Triangles& t, const std::array<Index, 3>& corners)
{
  return AlignedBox(t.points[corners[0]]).extend(t.points[corners[1]]).extend(t.points[corners[2]]);
}

inline TriangleBoxes boxes_of(const Triangles& t)
{
  std::vector<Index> all(t.corners.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<AlignedBox> boxes;
  boxes.reserve(all.size());
  for (const auto& corners : t.corners) boxes.push_back(box_of(t, corners));
  return {all.begin(), all.end(), boxes.begin(), boxes.end()};
}

}  // namespace berm::bodies
