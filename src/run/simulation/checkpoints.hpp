// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/checkpoint_folder.hpp"
#include "mesh/mesh.hpp"

#include <chrono>

namespace berm::simulation {

/// The folder of a run's checkpoints.
std::filesystem::path checkpoints_in(const std::filesystem::path& run_folder);

/// When a run writes its checkpoints, and what is said of them.
class Checkpoints {
public:
  /// wall_time: s between two of them; 0: only where they are requested.
  Checkpoints(const std::filesystem::path& run_folder, Real wall_time);

  /// One is to be written as soon as it can be.
  void ask() { asked_ = true; }
  bool due() const;
  /// Where it cannot be written the run continues with a warning: the one before it is still there. Returns whether it is written.
  bool write(BigIndex step, const checkpoint::Contents& contents);
  /// Another rank writes it.
  void skip_checkpoint() { last_ = Clock::now(), asked_ = false; }
  /// Reads the last one that can be used and says which; the others are reported with what is wrong with them. False where there is none. Throws
  /// RunError where there are some and none can be used.
  bool read(const checkpoint::Contents& contents);
  /// The run has come to its end.
  void remove() const { folder_.remove(); }

private:
  using Clock = std::chrono::steady_clock;

  checkpoint::CheckpointFolder folder_;
  Real wall_time_;
  Clock::time_point last_ = Clock::now();
  bool asked_ = false;
};

/// Refuses a checkpoint in which a text is not this run's own.
void archive_same(Archive& k, const std::string& name, const std::string& own, const std::string& why);

/// Refuses a checkpoint of another mesh.
template <int dim>
void archive_same_mesh(Archive& k, const mesh::Mesh<dim>& mesh);

/// Refuses a checkpoint whose history.csv is not there any more: `bytes` is its length, with all rows on the disk where a checkpoint is written. Forces the
/// names in its folder there, too.
void archive_history(Archive& k, const std::filesystem::path& history, BigIndex& bytes);

}  // namespace berm::simulation
