// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/writer_thread.hpp"
#include "mesh/mesh.hpp"
#include "run_folder/checkpoint_folder.hpp"

#include <atomic>
#include <chrono>
#include <memory>

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
  /// Takes the contents to a file; that this is whole and on the disk is up to the thread, after `vital`, which ends the run where it throws, and `before`, which only keeps the
  /// checkpoint from being there, as what is thrown by the contents does. Waits where the one before it is not done.
  void write(BigIndex step, const run_folder::Contents& contents, io::WriterThread& thread, const std::function<void()>& vital,
             const std::function<void()>& before);
  /// Warns of the last one where the thread could not finish it: the run continues, and the one before it is still there. Returns whether it is written, as far as it is known.
  bool tell();
  /// Another rank writes it.
  void skip_checkpoint() { last_ = Clock::now(), asked_ = false; }
  /// Reads the last one that can be used and says which; the others are reported with what is wrong with them. False where there is none. Throws
  /// RunError where there are some and none can be used.
  bool read(const run_folder::Contents& contents);
  /// The run has come to its end.
  void remove() const { folder_.remove(); }

private:
  using Clock = std::chrono::steady_clock;

  void warn(BigIndex step, const std::string& why);

  run_folder::CheckpointFolder folder_;
  Real wall_time_;
  Clock::time_point last_ = Clock::now();
  bool asked_ = false, written_ = true;
  BigIndex step_ = 0, piece_ = 0;  ///< of the last one; 0: none was handed over
  /// Why the thread could not finish it.
  struct Fault {
    std::atomic<bool> there = false;
    std::string why;
  };
  std::unique_ptr<Fault> fault_ = std::make_unique<Fault>();
};

/// Refuses a checkpoint in which a text is not this run's own.
void archive_same(Archive& k, const std::string& name, const std::string& own, const std::string& why);

/// Refuses a checkpoint of another mesh.
template <int dim>
void archive_same_mesh(Archive& k, const mesh::Mesh<dim>& mesh);

/// Refuses a checkpoint whose history.csv is not there any more: `bytes` is its length when a checkpoint is written.
void archive_history(Archive& k, const std::filesystem::path& history, BigIndex& bytes);

}  // namespace berm::simulation
