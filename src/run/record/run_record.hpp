// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/ground.hpp"
#include "run_folder/history.hpp"
#include "run_folder/origin.hpp"
#include "run_folder/summary_file.hpp"

namespace berm::record {

/// How a run ended, as its folder tells.
enum class RunEnd {
  finished,    ///< all of its stages
  stopped,     ///< its results are there, but not all of its stages: stopped by the user or by an error
  unfinished,  ///< no results: it was killed, crashed or still runs
  unknown      ///< its summary.json is damaged
};

/// All that a run folder holds, but the frames.
struct RunRecord {
  std::filesystem::path folder;
  std::string name;                               ///< of the folder, as valid UTF-8; a page tells runs apart by it
  settings::Case settings;                        ///< of resolved.toml
  problem::Ground ground;                         ///< where the bed is not level: of a mesh that berm made, or of ground.csv
  run_folder::History history;                    ///< without rows where there is none
  std::optional<run_folder::RunSummary> summary;  ///< none in an unfinished run
  std::vector<run_folder::Quantity> quantities;   ///< of the summary; of an unfinished run, what its structure makes of the history
  RunEnd end = RunEnd::unfinished;
  std::optional<run_folder::Origin> origin;  ///< none in a run of an earlier version, or where it is damaged
  std::string
      begun;  ///< date and time (UTC) of its origin; else those of the first line of run.log, in local time; "" where neither is there
  std::vector<std::string>
      changed;  ///< files of the folder that are others than origin.json noted when the run began, but for [report] of the case
  std::vector<std::string> warnings;  ///< of run.log, without their times
  std::string last_log_line;          ///< why the run ended, as run.log tells: its last line, or the warning before the results
  std::vector<std::string> faults;    ///< what is missing or damaged in the folder, in words

  /// A number of the summary's checks or timing; NaN where it is not there.
  Real check(const std::string& name) const;
  Real timing(const std::string& name) const;
  /// The level from which embedment counts of a body with its axis at x, m.
  Real surface_at(Real x) const { return ground.level_at(x, settings.surface); }
  /// The soil's surface at the start.
  problem::BedSurface bed_surface() const { return {settings.surface, ground.line}; }
  /// The quantity of that name, or null.
  const run_folder::Quantity* quantity(const std::string& name) const;
};

/// A name that files may have: letters, digits, points, - and _; everything else becomes _.
std::string file_name_of(const std::string& name);

/// What is said of a file in RunRecord::changed.
std::string words_of_change(const std::string& file);

/// Whether a folder is one of a run: it holds a resolved.toml that may be looked at.
bool is_run_folder(const std::filesystem::path& folder);

/// Writes ground.csv, the surface of a bed that is not level. Throws RunError where it cannot.
void write_ground(const std::filesystem::path& folder, const mesh::GroundLine& line);

/// Reads a run folder, as far as there is something: what is missing or damaged goes to `faults`; without a summary there are no quantities (structures::read_run
/// makes them). Throws InputError or RunError where its resolved.toml cannot be read.
RunRecord read_run(const std::filesystem::path& folder);

}  // namespace berm::record
