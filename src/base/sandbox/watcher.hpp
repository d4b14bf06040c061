// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace berm::sandbox {

/// What a watcher allows.
struct Allowed {
  std::vector<std::filesystem::path> folders;   ///< to write below, as the system calls them: absolute, without links
  std::vector<std::filesystem::path> programs;  ///< to start
  std::vector<std::filesystem::path> quiet;     ///< of these, whose attempts to write elsewhere are nobody's business
  std::vector<std::filesystem::path> made;      ///< folders to remove at the end where they are empty, the innermost first
};

/// A process beside this one that is asked, by the kernel, before a call that opens a socket, starts a program or changes files: it refuses what is not allowed, and notes it.
/// What Landlock knows is refused by Landlock, too; the watcher gives it its name.
class Watcher {
public:
  /// From now on, and for good, this process and what it starts are watched. Throws std::system_error.
  explicit Watcher(const Allowed& allowed);

  /// What was refused, a line each.
  std::string notes() const;
  /// Removes the folders that were made and are empty.
  void tidy_up();

private:
  /// The watcher writes there, and the watched can only read.
  struct Notes {
    static constexpr std::size_t size = 8192;
    std::atomic<std::size_t> length;
    char text[size];
  };

  const Notes* notes_;  ///< kept to the end of the program
  int line_;            ///< to the watcher
};

}  // namespace berm::sandbox
