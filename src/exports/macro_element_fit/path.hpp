// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::macro_element_fit {

/// Where the pipe of a run was, and how the soil answered; means over some rows of its history.
struct PathPoint {
  Real u, w;      ///< m
  Real H, V;      ///< N/m
  bool by_force;  ///< V was given, and w followed; else w was given
};

/// The way of the pipe of a run, from the seabed (or from where it lay in it) on.
struct Path {
  std::string name;
  std::filesystem::path run;
  Real diameter = nan;               ///< m
  Real friction = 0;                 ///< coefficient of the interface between pipe and soil
  std::vector<std::string> invalid;  ///< why its answer is not to be used; empty where nothing says so
  std::vector<PathPoint> points;
  std::vector<PathPoint> push;  ///< those of the first push that is driven by velocity, where V is the resistance of fresh soil

  Real largest_H() const;  ///< by size
  Real largest_V() const;
};

/// The path of a run. Throws RunError where it is no run of a pipe in plane strain, has not come to its end, or where the pipe never touched the soil.
Path path_of(const record::RunRecord& run);

/// Those of run folders and of the runs of studies. Throws RunError as above, and where a folder is neither.
std::vector<Path> paths_in(const std::vector<std::string>& folders);

}  // namespace berm::macro_element_fit
