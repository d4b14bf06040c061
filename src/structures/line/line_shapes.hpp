// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::line {

/// The shape of a line when a frame was written, by node.
struct LineShape {
  Real time = 0;  ///< s
  std::string stage;
  std::vector<Real> y, z, u;                 ///< m: sideways from the straight axis, upwards and along the line from where it was laid
  std::vector<Real> P;                       ///< N, effective compression
  std::vector<Real> M;                       ///< N m, lateral bending moment
  std::vector<Real> strain_max, strain_min;  ///< longitudinal strain
};

/// What line.csv holds.
struct LineShapes {
  std::vector<Real> x;  ///< m, of the nodes
  std::vector<LineShape> frames;
};

/// Reads a line.csv; without frames where there is no such file. Throws RunError with file and line for anything else.
LineShapes read_line_shapes(const std::filesystem::path& file);

}  // namespace berm::line
