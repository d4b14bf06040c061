// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"
#include "simulation/simulate.hpp"

#include <CLI/CLI.hpp>

namespace berm::commands {

/// Options of the commands that run cases: the cases, changes to them, where results go, and on how many threads.
struct CaseOptions {
  std::vector<std::string> files, overrides;
  std::string output;
  int threads = 0;           ///< 0: all processors
  bool force = false;        ///< replace the results of earlier runs
  bool uncertainty = false;  ///< find the bands of the results, too
  bool no_programs = false;  ///< refuse cases that bring programs
  bool sandbox = false;      ///< where no case brings programs, too
  bool text_from_stdin = false;
  bool strict = false;  ///< a run whose answer is invalid has failed
  std::string runner_words, sbatch;
  int pack = 0;  ///< runs a task of Slurm; 0: not said
  bool no_wait = false;

  /// CASE... and --set.
  CLI::Option* take_cases(CLI::App& command);
  /// --stdin: the text of the case, as if it lay in the file.
  void take_stdin(CLI::App& command);
  /// --threads: of one run, or runs at a time.
  void take_threads(CLI::App& command);
  void take_jobs(CLI::App& command);
  int jobs() const;
  /// --no-programs.
  void take_no_programs(CLI::App& command);
  /// With it: throws InputError where the case names a program, a geometry that gmsh runs or a library with a law.
  void refuse_programs(const simulation::RunRequest& request) const;
  /// --sandbox and --no-sandbox.
  void take_sandbox(CLI::App& command);
  /// From now on this program writes to `folders` only (sandbox/sandbox.hpp): where the cases bring libraries, which become a part of it, or --sandbox asks for it. Where the system has no
  /// sandbox a warning says why; throws RunError where --sandbox asks for one.
  void enter_sandbox(bool brings_libraries, const std::vector<std::filesystem::path>& folders) const;
  /// Of a case that brings a library: throws InputError where berm has chosen the folder itself, and a part of it is a link, which whoever sent the case may have made.
  void refuse_links(const std::filesystem::path& folder) const;
  /// --runner and what goes with it.
  void take_runner(CLI::App& command);
  /// What runs the cases. Throws InputError where it cannot.
  jobs::Runner runner() const;
  bool has_runner() const { return !runner_words.empty(); }
};

/// Where the results of a case go by default: out/FOLDER/NAME of FOLDER/NAME.toml, so that examples/bar/case.toml and examples/column/case.toml do not meet; out/NAME
/// of a file that lies here.
std::filesystem::path default_folder(const std::filesystem::path& file);

/// Reads all cases, before the first one runs, so that a wrong one costs nothing. One case goes to `output` itself, several to folders in it that are
/// named like their files. Throws InputError.
std::vector<simulation::RunRequest> requests(const CaseOptions& options);

/// Whether a case names a geometry that gmsh runs or a library with a law.
bool brings_programs(const simulation::RunRequest& request);
/// Whether it names a library with a law.
bool brings_libraries(const simulation::RunRequest& request);

/// Messages of commands that write no run.log go to stderr.
void messages_to_stderr();

}  // namespace berm::commands
