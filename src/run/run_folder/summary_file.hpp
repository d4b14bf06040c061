// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "run_folder/uncertainty.hpp"

#include <map>
#include <optional>

namespace berm::run_folder {

/// What summary.json says of a run. A number that was not finite is NaN.
struct RunSummary {
  std::vector<Quantity> quantities;
  std::map<std::string, Real> timing;  ///< wall_s, threads, cells, steps, particles, particle_steps_per_s, nodes, iterations ...
  std::map<std::string, Real> checks;  ///< true is 1, false 0
  std::map<std::string, std::string> text;
  std::vector<std::string> warnings;         ///< what was doubtful of the case before it ran
  std::optional<Uncertainty> uncertainty{};  ///< where it was asked for
  std::vector<std::string> invalid{};        ///< why its numbers are not to be used; empty in one of an earlier version

  /// All of its stages were run.
  bool finished() const;
};

/// Reads summary.json of a run folder, as Summary writes it; empty where there is none. Throws RunError "FILE is damaged: WHY" where any of it
/// is not of that form, or "FILE cannot be read".
std::optional<RunSummary> read_summary(const std::filesystem::path& run_folder);

}  // namespace berm::run_folder
