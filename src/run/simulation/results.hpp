// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame.hpp"
#include "run_folder/history.hpp"
#include "run_folder/run_folder.hpp"
#include "run_folder/summary.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// What a run found out about itself.
struct RunOutcome {
  const run_folder::History& history;  ///< all rows, those before it was resumed, too
  bool finished;
  std::vector<Real> held_forces;       ///< N/m, V that each stage holds; NaN where none
  run_folder::Summary::Checks checks;  ///< others than "finished"
  std::vector<std::string> warnings;   ///< what was doubtful of the case before it ran
};

/// Writes what follows from the history and from the last frame: summary.json, curves, pictures; logs the time by loop and gives the
/// key results in words, "" where there is none. `rigid_bodies` says where the rigid bodies are at the end.
template <int dim>
std::string write_results(const RunRequest& request, const run_folder::RunFolder& folder, const problem::Model<dim>& model,
                          const std::vector<bodies::RigidState<dim>>& rigid_bodies, const run_folder::Frame<dim>& last,
                          const RunOutcome& outcome, const run_folder::RunTiming& timing);

/// The key results of a run under their heading, "" where the table is empty; of a run whose answer is spoiled with why, and a mark behind every line.
std::string key_results(const std::string& table, const std::vector<std::string>& spoiled);

}  // namespace berm::simulation
