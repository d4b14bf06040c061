// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/child_process.hpp"

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace berm::desk {

/// A process of this program that one thread waits for while others may send it signals.
class Process {
public:
  /// `messages`: the open file of what it prints; `outlives`: it goes on where the desk ends. Throws RunError where it cannot be started.
  Process(std::vector<std::string> words, const std::filesystem::path& folder, int messages, bool outlives, int in = -1);

  /// Waits until it has ended, at most so long, and ends it then. Its exit status, 128 + N after signal N.
  int wait(std::chrono::steady_clock::duration at_most = std::chrono::hours(24 * 365));
  /// Nothing once it has ended.
  void send(int signal);

private:
  std::mutex mutex_;
  bool ended_ = false;
  ChildProcess child_;
};

}  // namespace berm::desk
