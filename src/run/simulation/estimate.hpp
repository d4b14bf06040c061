// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>
#include <vector>

namespace berm::simulation {

/// What a run of a case would be and take.
struct Estimate {
  std::vector<std::string> lines;  ///< all of it in words: `memory       about 12 MiB at most`
  BigIndex cells = 0, nodes = 0;
  BigIndex particles = 0;  ///< 0 in finite elements
  Real memory = nan;       ///< largest, bytes
  Real time = nan;         ///< wall time on a free machine, s; NaN where no stage says how long it takes
  Real disk = nan;         ///< bytes
};

}  // namespace berm::simulation
