// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// Notes in the run folder which case file it is of, for summary.json of a resumed run.
void note_case_file(const run_folder::RunFolder& folder, const std::filesystem::path& case_file);

/// The run in this folder, as its resolved.toml says, to resume; empty where it is finished. Throws InputError where the folder holds no run,
/// RunError where it has no checkpoints and its summary.json is damaged.
std::optional<RunRequest> run_to_resume(const std::filesystem::path& folder);

}  // namespace berm::simulation
