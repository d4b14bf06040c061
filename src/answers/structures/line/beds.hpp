// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <vector>

namespace berm::line {

/// How far the soil in the slices of a line has risen since before the pipe was laid, in columns side by side.
struct Beds {
  Index first_frame = 0;                ///< of line.csv that has them
  std::vector<Real> x;                  ///< m, of the slices, along the line
  std::vector<Real> y;                  ///< m, of the middles of the columns, sideways
  std::vector<std::vector<Real>> rise;  ///< m, by frame: rise[frame - first_frame][slice * y.size() + column]
};

/// What berms.csv of a run folder holds; nothing without that file. Throws RunError, with file and line, where it is damaged.
Beds read_beds(const std::filesystem::path& folder);

}  // namespace berm::line
