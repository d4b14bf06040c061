// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/places.hpp"
#include "settings/case.hpp"
#include "simulation/context.hpp"
#include "simulation/estimate.hpp"
#include "user_law/load.hpp"

#include <filesystem>

namespace berm::simulation {

/// One case to run.
struct RunRequest {
  settings::Case settings;
  std::filesystem::path case_file;
  std::filesystem::path folder;       ///< the run folder
  bool resume = false;                ///< from the last checkpoint in the run folder, or from the start where there is none yet
  input::Places places = {};          ///< where the keys of the case were written, for messages
  user_law::GivenLaws laws = {};      ///< of the caller's own, in place of libraries that the case names
  std::vector<std::string> set = {};  ///< what was changed in the case file, each KEY=VALUE: noted in origin.json
  std::shared_ptr<const RunRequest> shorter = {};  ///< the run as it was begun, where it is resumed on a longer mesh (lengthened())
};

// All of them refuse a case that makes no sense (sanity/questions.hpp), with InputError; what is doubtful is a warning.

/// Runs a case from its first to its last stage and writes its run folder. Nothing is written before the problem is built. A run that the context
/// asks to stop ends after the step in hand; what was computed is written all the same, with a checkpoint to resume from. Returns whether the run came
/// to its end. Throws InputError and RunError.
bool run_case(const RunRequest& request, Context& context);

/// Builds the problem and drops it. Throws InputError where the case does not fit its mesh, makes no sense, or needs more memory than there is.
void check_buildable(const RunRequest& request);

/// What `berm check` says of a case.
struct Checked {
  std::vector<input::Located> refusals, warnings;
  std::vector<std::string> notes;         ///< on supports that move
  std::optional<input::Located> failure;  ///< of the first steps
  std::optional<Estimate> estimate;       ///< none of a case that is refused or fails
};

/// Builds the problem and tells what it is and what a run would take. Throws InputError where it cannot be built.
Checked check_case(const RunRequest& request, Context& context);

/// Builds the problem and tells the wall time that a run would take on one thread, s, from the number of its steps and the time of the first ones; NaN where no stage says how
/// long it takes. Throws InputError and RunError where it cannot be built.
Real expected_wall_time(const RunRequest& request);

}  // namespace berm::simulation
