// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace berm::io {

/// A folder of the system's temporary ones, removed with this object.
class ScratchFolder {
public:
  /// Throws RunError where the system's temporary folder cannot be written to.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Throws RunError where that is not possible.
  void move_files_to(const std::filesystem::path& folder) const;

private:
  std::filesystem::path path_;
};

}  // namespace berm::io
