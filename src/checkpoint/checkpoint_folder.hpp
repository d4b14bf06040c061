// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/checkpoint_file.hpp"

namespace berm::checkpoint {

/// The checkpoints of one run, in a folder of their own: step_N.h5 with N the step. The last two are kept.
class CheckpointFolder {
public:
  explicit CheckpointFolder(std::filesystem::path path) : path_(std::move(path)) {}

  /// Files that bear a checkpoint's name, the one of the last step first.
  std::vector<std::filesystem::path> files() const;

  /// Reads the last one that can be read, and gives its path; empty where there is no file. What is refused is told to `refused` with the reason. Throws
  /// RunError where none of several files can be read.
  std::filesystem::path read(const Contents& contents,
                             const std::function<void(const std::filesystem::path&, const std::string&)>& refused);

  /// Makes the folder where it is missing, writes one, and then removes all others but the one that was written or read before it. Throws RunError.
  void write(BigIndex step, const Contents& contents);

  /// Removes the folder: the run has come to its end.
  void remove() const;

private:
  std::filesystem::path path_, last_;
};

}  // namespace berm::checkpoint
