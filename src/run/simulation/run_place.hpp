// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/scratch_folder.hpp"
#include "run_folder/run_folder.hpp"
#include "run_folder/run_log.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// The case with the mesh that lies in the run folder, where a run is resumed: the file that it was read from may be elsewhere or gone.
settings::Case case_to_run(const RunRequest& request);

/// The run folder, with case.toml, resolved.toml, the mesh files that building left in `scratch` and run.log, while the run writes there. It begins with what
/// is run (`size`: "3052 elements, 6287 nodes, 2 threads") and what is doubtful of it (`warnings`); messages go where the context says, and to the log. A
/// resumed run finds all but the log there, which is appended to. Of ranks that are not the first: a folder in `scratch`.
class RunPlace {
public:
  RunPlace(const RunRequest& request, const Context& context, const io::ScratchFolder& scratch, const std::string& size,
           const std::vector<std::string>& warnings);

  /// Replaces what the run was begun with by what it goes on with on a longer mesh, all of it or, where that is cut short, nothing. `keep` puts the checkpoint into a folder.
  void lengthen(const RunRequest& request, const io::ScratchFolder& scratch, const std::vector<std::string>& warnings,
                const std::function<void(const std::filesystem::path&)>& keep);

  const run_folder::RunFolder& folder() const { return folder_; }
  run_folder::RunLog& log() { return log_; }

private:
  bool replaces_;  ///< an unfinished run; known before its folder is made anew
  run_folder::RunFolder folder_;
  run_folder::RunLog log_;
};

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

}  // namespace berm::simulation
