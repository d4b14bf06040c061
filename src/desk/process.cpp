// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/process.hpp"

#include "os/error.hpp"

#include <csignal>
#include <fmt/format.h>
#include <system_error>
#include <thread>

namespace berm::desk {
namespace {

ChildProcess started(std::vector<std::string> words, const std::filesystem::path& folder, int messages, bool outlives, int in)
{
  words.insert(words.begin(), "berm");
  try {
    return ChildProcess({.words = std::move(words),
                         .program = "/proc/self/exe",
                         .out = messages,
                         .in = in,
                         .folder = folder.string(),
                         .outlives = outlives});
  } catch (const std::system_error& error) {
    throw RunError(fmt::format("no process can be started: {}", error.code().message()));
  }
}

}  // namespace

Process::Process(std::vector<std::string> words, const std::filesystem::path& folder, int messages, bool outlives, int in)
    : child_(started(std::move(words), folder, messages, outlives, in))
{
}

int Process::wait(std::chrono::steady_clock::duration at_most)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (true) {
    const auto since = Clock::now() - begin;
    {
      const std::lock_guard lock(mutex_);
      if (since > at_most) child_.send(SIGKILL);
      ended_ = since > at_most || child_.has_ended();
      if (ended_) return child_.wait();
    }
    // Who waits for an answer learns it at once; a run of a day costs next to nothing.
    std::this_thread::sleep_for(since < std::chrono::seconds(10) ? std::chrono::milliseconds(5) : std::chrono::milliseconds(250));
  }
}

void Process::send(int signal)
{
  const std::lock_guard lock(mutex_);
  if (!ended_) child_.send(signal);
}

}  // namespace berm::desk
