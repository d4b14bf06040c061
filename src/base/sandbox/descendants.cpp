// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/descendants.hpp"

#include "os/read_file.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <poll.h>
#include <sstream>
#include <string>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace berm::sandbox {
namespace {

namespace fs = std::filesystem;

/// Those whose parent is one of the threads of the process.
std::vector<pid_t> children_of(pid_t process)
{
  std::vector<pid_t> all;
  std::error_code error;
  for (fs::directory_iterator task(fs::path("/proc") / std::to_string(process) / "task", error), end; !error && task != end;
       task.increment(error)) {
    constexpr std::uintmax_t most = 1 << 20;
    std::istringstream children(read_file(task->path() / "children", most).bytes);
    for (pid_t child = 0; children >> child;) all.push_back(child);
  }
  return all;
}

bool has_ended(int descriptor)
{
  pollfd one{descriptor, POLLIN, 0};
  return ::poll(&one, 1, 0) == 1;
}

}  // namespace

Descendants::Descendants(pid_t of) : of_(of), others_(children_of(of)) {}

void Descendants::add_children_of(pid_t process, std::vector<pid_t>& added)
{
  for (const pid_t child : children_of(process)) {
    if (known_.contains(child) || std::find(others_.begin(), others_.end(), child) != others_.end()) continue;
    const int descriptor = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
    if (descriptor < 0) continue;
    if (has_ended(descriptor)) {  // its parent has not taken note of it yet
      ::close(descriptor);
      continue;
    }
    known_[child] = descriptor;
    added.push_back(child);
  }
}

void Descendants::look()
{
  std::erase_if(known_, [](const auto& child) {
    const bool ended = has_ended(child.second);
    if (ended) ::close(child.second);
    return ended;
  });
  std::vector<pid_t> to_ask = {of_};
  for (const auto& [child, descriptor] : known_) to_ask.push_back(child);
  while (!to_ask.empty()) {
    const pid_t process = to_ask.back();
    to_ask.pop_back();
    add_children_of(process, to_ask);
  }
}

void Descendants::end()
{
  constexpr int most = 1000;  // one that waits for a device ends later
  for (int turn = 0; turn < most; ++turn) {
    look();
    if (known_.empty()) return;
    for (const auto& [child, descriptor] : known_) ::syscall(SYS_pidfd_send_signal, descriptor, SIGKILL, nullptr, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace berm::sandbox
