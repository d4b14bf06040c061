// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/jobs/jobs_test.cpp
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/scheduler.hpp"
#include "jobs/shell.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

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
      throw RunError(
          fmt::format("the runs were handed to {}: collect them by the same --runner, or cancel them and remove the folder queue", handle));
    if (!started_) return true;
    if (wait_) return works();
    while (works() && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return !ended_ || status_ == 0;
  }

  void leave(const std::string&) override
  {
    if (!started_ || !works()) {
      io::tell("the runs that were handed over stay so; the same command collects them\n");
      return;
    }
    io::tell("stopped: the command of --runner and what it has started are asked to end\n");
    ::kill(-process_, SIGTERM);
    while (works() || group_lives()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  std::string complaint() override
  {
    return started_ && !works() && status_ != 0 ? fmt::format("--runner: the command ended with status {} before any run began", status_)
                                                : "";
  }

  Real pause(Real) const override { return 0.1; }

private:
  /// In a process group of its own, which Ctrl-C does not reach: `leave` stops it.
  void start(const std::string& command)
  {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // for group_lives: what the command leaves behind becomes a child of this process
    process_ = ::fork();
    if (process_ < 0) io::throw_errno("no process can be started");
    if (process_ == 0) {
      ::setpgid(0, 0);
      ::dup2(STDERR_FILENO, STDOUT_FILENO);
      if (const int nothing = ::open("/dev/null", O_RDONLY); nothing >= 0)
        ::dup2(nothing, STDIN_FILENO);  // the terminal is another group's
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    ::setpgid(process_, process_);
    started_ = true;
  }

  bool works()
  {
    if (ended_) return false;
    int status = 0;
    ended_ = ::waitpid(process_, &status, WNOHANG) == process_;
    if (ended_) status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return !ended_;
  }

  /// Whether anything that the command started is there; what has ended is forgotten.
  bool group_lives() const
  {
    while (::waitpid(-process_, nullptr, WNOHANG) > 0) {
    }
    return ::kill(-process_, 0) == 0;
  }

  std::string command_;
  bool wait_, started_ = false, ended_ = false;
  pid_t process_ = 0;
  int status_ = 0;
};

}  // namespace

std::unique_ptr<Scheduler> scheduler_for(const ShellCommand& command, bool wait)
{
  return std::make_unique<ShellScheduler>(command.command, wait);
}

}  // namespace berm::jobs
