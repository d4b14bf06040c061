// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"
#include "safety/search.hpp"
#include "settings/case.hpp"

#include <filesystem>

namespace berm::safety {

/// A factor of safety to find.
struct SafetyRequest {
  settings::Case settings;
  std::filesystem::path case_file;
  std::filesystem::path folder;
  SearchSettings how;
  jobs::Runner runner;
};

/// The case that a trial runs; safety.movement stays.
settings::Case trial_case(settings::Case settings, Real factor);

/// Looks for the largest factor by which the strength of the soil can be divided so that it stands: runs trials side by side, FOLDER/runs/F_1.3750.toml into FOLDER/runs/F_1.3750, round by round, and
/// writes safety.csv, summary.json, figures and safety.html. Trials that have a result are not run again, whatever the settings of the search were. Ctrl-C stops it; the same command goes on. Throws
/// InputError where the case cannot be a trial (settings::check_safety) or built, before anything is written.
jobs::Outcome find_safety(const SafetyRequest& request);

}  // namespace berm::safety
