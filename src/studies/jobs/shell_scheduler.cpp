// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/jobs/jobs_test.cpp
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/scheduler.hpp"
#include "jobs/shell.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <optional>
#include <thread>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

constexpr const char* any_handle = "command";

std::string replaced(std::string text, const std::string& word, const std::string& by)
{
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size())) text.replace(at, word.size(), by);
  return text;
}

/// A command that works through the jobs until it ends, or that passes them on: which of the two is not known, so what an earlier command started may
/// be at work until each job has ended.
class ShellScheduler final : public Scheduler {
public:
  ShellScheduler(std::string command, bool wait) : command_(std::move(command)), wait_(wait) {}

  std::string submit(const fs::path& queue, std::size_t count) override
  {
    start(replaced(replaced(command_, "{jobs}", quoted((queue / "jobs").string())), "{count}", std::to_string(count)));
    return any_handle;
  }

  bool works_on(const std::string& handle) override
  {
    if (handle.empty()) return false;
    if (handle != any_handle)
      throw RunError(fmt::format(
          "the runs were submitted to {}: collect them by the same --runner, or cancel them and remove the folder queue", handle));
    if (!process_) return true;
    if (wait_) return works();
    while (works() && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return works() || process_->wait() == 0;
  }

  void leave(const std::string&) override
  {
    if (!process_ || !works()) {
      io::tell("submitted runs continue; the same command collects them\n");
      return;
    }
    io::tell("stopped: the command of --runner and what it has started are asked to end\n");
    process_->send(SIGTERM);
    while (works() || process_->group_lives()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  std::string complaint() override
  {
    const bool failed = process_ && !works() && process_->wait() != 0;
    return failed ? fmt::format("--runner: the command ended with status {} before any run began", process_->wait()) : "";
  }

  Real pause(Real) const override { return 0.1; }

private:
  void start(const std::string& command)
  {
    adopt_orphans();  // for group_lives
    process_.emplace(started_shell(command));
  }

  bool works() { return !process_->has_ended(); }

  std::string command_;
  bool wait_;
  std::optional<ChildProcess> process_ = {};  ///< the command, once it was started
};

}  // namespace

std::unique_ptr<Scheduler> scheduler_for(const ShellCommand& command, bool wait)
{
  return std::make_unique<ShellScheduler>(command.command, wait);
}

}  // namespace berm::jobs
