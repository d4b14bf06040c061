// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace berm::io {

/// Locks a folder for this process: its file `lock`, which names process and host, is locked while this object lives.
class FolderLock {
public:
  static constexpr const char* file_name = "lock";

  /// Throws RunError where another process has the folder, or where the file cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Who has the folder, "another process" where the lock does not tell; "" nobody.
  static std::string owner_of(const std::filesystem::path& folder);

private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace berm::io
