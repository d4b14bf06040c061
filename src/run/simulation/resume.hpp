// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// Notes in the run folder which case file it is of, for summary.json of a resumed run. From here on the run has begun: all that it was given is in the folder.
void note_case_file(const run_folder::RunFolder& folder, const std::filesystem::path& case_file);

/// The run in this folder, as its resolved.toml says, to resume; empty where it is finished. Throws InputError where the folder holds no run,
/// RunError where it has no checkpoints and its summary.json is damaged.
std::optional<RunRequest> run_to_resume(const std::filesystem::path& folder);

/// The request that the finished run in this folder came from, as its resolved.toml says.
RunRequest finished_run(const std::filesystem::path& folder);

/// Whether the folder holds a run that has begun: before that there is nothing to lose.
bool has_begun(const std::filesystem::path& folder);

/// Whether the folder holds a run that did not come to its end.
bool can_be_resumed(const std::filesystem::path& folder);

/// Whether the folder holds a checkpoint.
bool has_checkpoint(const std::filesystem::path& folder);

/// The key results of a finished run in its folder, in words; "" where there are none.
std::string key_results_in(const RunRequest& request);

}  // namespace berm::simulation
