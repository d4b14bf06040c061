// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace berm::run_folder {

/// What a quantity is for.
enum class QuantityKind {
  answer,     ///< what the run was made for; it has a band of its own
  ratio,      ///< the dimensionless twin of another
  quality,    ///< tells how good the run is
  prescribed  ///< a number of the input, met as exactly as a step can
};

/// What summary.json calls it.
const char* word_of(QuantityKind kind);

/// One result of a run. unit as UDUNITS-2 spells it, "1" for a bare number.
struct Quantity {
  std::string name;
  Real value;
  std::string unit;
  std::string meaning = {};  ///< in some words; "" without any
  QuantityKind kind = QuantityKind::answer;
  std::string of = {};  ///< the travel or the state that it is of; "" of the run
};

/// What a run of the material point method counts.
struct MpmCounts {
  BigIndex particles = 0;
};

/// What a run of the finite element method counts.
struct FemCounts {
  BigIndex nodes = 0, iterations = 0;  ///< iterations: of all steps together
};

/// What the parts of a run take of its wall time, s: a part that waits for a thread or for the disk counts as if it worked.
struct TimeOfParts {
  Real steps = 0, rows = 0, frames = 0, checkpoints = 0;
  Real beside = 0;  ///< of the thread that writes files while the run steps on: no part of the others
};

/// How long a run took.
struct RunTiming {
  Real wall_s = 0;
  Real processors_s = nan;  ///< time that its threads had a processor, added up
  TimeOfParts parts = {};
  int threads = 1;
  BigIndex cells = 0, steps = 0;
  std::variant<MpmCounts, FemCounts> counts;
  std::vector<Timing> loops;
  std::vector<Real> memory{nan};  ///< of each rank's process when it had most, bytes; NaN: not known
};

/// Particles times steps, over the wall time.
Real particle_steps_per_s(const RunTiming& timing, const MpmCounts& counts);

/// The SI unit of a number in the timing of summary.json; "1" = a bare number.
const char* unit_of_timing(const std::string& name);

/// The names of all checks and of all numbers of the timing that a run may have.
std::vector<std::string> check_and_timing_names();

/// What summary.json says of a run.
class Summary {
public:
  using Checks = std::vector<std::pair<std::string, std::variant<bool, Real>>>;

  std::vector<Quantity> quantities;
  std::optional<Quantity> force_measure;  ///< what forces per metre are divided by, on the page and in pictures
  RunTiming timing;
  Checks checks;                                          ///< e.g. energy balance, reached the end
  std::vector<std::pair<std::string, std::string>> text;  ///< e.g. title, version
  std::vector<std::string> warnings;                      ///< what was doubtful of the case before it ran: "FILE:LINE: KEY: MESSAGE"
  std::vector<std::string> invalid;                       ///< why its numbers are not to be used, a sentence each

  /// {"quantities": {NAME: {"value", "unit", "meaning", "kind", "of"}}, "force_measure": {"name", "value", "unit", "meaning"}, "timing": {...}, "checks": {NAME: number or bool}, "text": {NAME: words}, "warnings": [words], "invalid": [words]}, in the order in which
  /// they were added. Timing has wall_s, threads, cells, steps and loops; in MPM also particle_steps_per_s, particles and seconds_per_step (wall
  /// time over steps), in FEM nodes and iterations; processors_s, steps_s, rows_s, frames_s, checkpoints_s and beside_s (TimeOfParts). A number that is not finite becomes null.
  std::string json() const;
  /// Writes it whole. Throws RunError.
  void write(const std::filesystem::path& path) const;
};

}  // namespace berm::run_folder
