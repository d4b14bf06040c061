// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::line {

/// The line at a moment, by node.
struct Shape {
  Real time;  ///< s
  std::string stage;
  std::vector<Real> x, y, z, u;              ///< m, along the line, sideways, upwards, and along the line as a displacement
  std::vector<Real> P, M;                    ///< N, N m, compression and lateral moment
  std::vector<Real> strain_max, strain_min;  ///< longitudinal
};

/// What line.csv of a run folder holds, in the order of time, all at the nodes of the first; none without that file. Throws RunError, with file and line, where it is damaged.
std::vector<Shape> read_shapes(const std::filesystem::path& folder);

/// The last of a stage; null where it has none.
const Shape* last_of(const std::vector<Shape>& shapes, const std::string& stage);

}  // namespace berm::line
