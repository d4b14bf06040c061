// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/checkpoint_file.hpp"

namespace berm::run_folder {

/// The checkpoints of one run, in a folder of their own: step_N.h5 with N the step. The last two are kept.
class CheckpointFolder {
public:
  explicit CheckpointFolder(std::filesystem::path path) : path_(std::move(path)) {}

  /// Files with the name of a checkpoint, that of the last step first.
  std::vector<std::filesystem::path> files() const;

  /// Reads the last one that is readable, and returns its path; empty where there is no file. `refused` is called with each
  /// file that is refused and the reason. Throws RunError where there are files but none can be read.
  std::filesystem::path read(const Contents& contents,
                             const std::function<void(const std::filesystem::path&, const std::string&)>& refused);

  /// Writes a checkpoint in two parts, which throw RunError: begin() makes the folder where it is missing and takes the contents; what it returns, for any thread to
  /// call once and in order, makes a whole file of them, and then removes all but it and the one that was written or read before.
  std::function<void()> begin(BigIndex step, const Contents& contents);

  /// Removes the folder at the end of the run.
  void remove() const;

private:
  std::filesystem::path path_, last_;
};

}  // namespace berm::run_folder
