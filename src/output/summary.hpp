// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace berm {

/// One result of a run. unit as UDUNITS-2 spells it, "1" for a bare number.
struct Quantity {
  std::string name;
  Real value;
  std::string unit;
};

/// How long a run took.
struct RunTiming {
  Real particle_steps_per_s = 0, wall_s = 0;
  int threads = 1;
  BigIndex particles = 0, cells = 0, steps = 0;
  std::vector<Timing> loops;
};

/// What summary.json says of a run.
class Summary {
public:
  using Check = std::variant<bool, Real>;

  std::vector<Quantity> quantities;
  RunTiming timing;
  std::vector<std::pair<std::string, Check>> checks;      ///< e.g. energy balance, reached the end
  std::vector<std::pair<std::string, std::string>> text;  ///< e.g. title, version

  /// {"quantities": {NAME: {"value", "unit"}}, "timing": {...; seconds_per_step is the wall time over the steps}, "checks": {NAME: number or bool}, "text": {NAME: words}}, in the order in which
  /// they were added. A number that is not finite becomes null.
  std::string json() const;
  /// Writes it whole. Throws RunError.
  void write(const std::filesystem::path& path) const;
};

}  // namespace berm
