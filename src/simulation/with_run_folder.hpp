// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/scratch_folder.hpp"
#include "run_folder/run_folder.hpp"
#include "run_folder/run_log.hpp"
#include "simulation/simulate.hpp"

#include <functional>

namespace berm::simulation {

/// The case with the mesh that lies in the run folder, where a run is resumed: the file that it was read from may be elsewhere or gone.
problem::Case to_build(const RunRequest& request);

/// Makes the run folder with case.toml, resolved.toml, the mesh files that building left in `scratch` and run.log, says what is run (`size`: "3052 elements,
/// 6287 nodes, 2 threads") and what is doubtful of it (`warnings`), and runs; messages go where the context says, and to the log. A resumed run finds all but the log there, which is appended to. A RunError goes to run.log as well. Returns what `run` does.
bool with_run_folder(const RunRequest& request, const Context& context, const io::ScratchFolder& scratch, const std::string& size,
                     const std::vector<std::string>& warnings,
                     const std::function<bool(const run_folder::RunFolder&, run_folder::RunLog&)>& run);

/// Runs, then writes the results of what was computed. A run that fails (RunError) leaves them too before its error is passed on; an error in writing them is then
/// only logged.
void run_then_write_results(const std::function<void()>& run, const std::function<void()>& leave_results);

}  // namespace berm::simulation
