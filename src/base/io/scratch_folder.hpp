// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/child_process.hpp"

#include <filesystem>
#include <optional>

namespace berm::io {

/// A folder of the system's temporary ones, removed with this object, or by a shell that waits for the end of this program where it is killed.
class ScratchFolder {
public:
  /// The variable of the environment that names a temporary folder, removed by whoever made it: all others are made in it.
  static constexpr const char* outer_variable = "BERM_SCRATCH";

  /// Throws RunError where the system's temporary folder cannot be written to, or the shell cannot be started.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Throws RunError where that is not possible.
  void move_files_to(const std::filesystem::path& folder) const;

private:
  void start_guard();
  void remove();

  std::filesystem::path path_;
  std::optional<ChildProcess> guard_;
  int held_ = -1;  ///< open as long as this program lives
};

}  // namespace berm::io
