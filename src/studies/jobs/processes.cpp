// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "jobs/processes.hpp"

#include "core/interrupt.hpp"
#include "io/atomic_file.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <map>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

/// Starts the job and returns its process, which gets signals from this program alone and is asked to stop when this program
/// ends.
pid_t start(const Job& job)
{
  std::vector<std::string> words = words_of(job);
  words.insert(words.begin(), "berm");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  io::make_folder(job.folder.parent_path());
  const fs::path messages = messages_of(job);
  const int out = io::open_to_write(messages, O_WRONLY | O_TRUNC);
  const pid_t child = ::fork();
  if (child != 0) {
    const int reason = errno;
    ::close(out);
    errno = reason;
    if (child < 0) io::throw_errno("no process can be started");
    return child;
  }
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int in = ::open("/dev/null", O_RDONLY);
  if (in >= 0 && ::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 && ::dup2(out, STDERR_FILENO) >= 0)
    ::execv("/proc/self/exe", arguments.data());
  ::_exit(127);
}

JobEnd end_of(const Job& job, int status, bool stopped)
{
  const JobEnd end = end_with(job, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
  std::error_code ignored;
  if (end.kind == JobEnd::Kind::finished) fs::remove(messages_of(job), ignored);
  return end.kind == JobEnd::Kind::failed && stopped ? JobEnd{} : end;
}

}  // namespace

void run_processes(const std::vector<Job>& jobs, int at_once, const Ended& ended)
{
  std::map<pid_t, std::size_t> running;
  bool stopping = false;
  const auto stop = [&] {
    for (const auto& entry : running) ::kill(entry.first, SIGTERM);
    stopping = true;
  };
  const std::vector<std::size_t> order = by_time(jobs);
  std::size_t next = 0;
  while (true) {
    if (interrupted() && !stopping) stop();
    while (!stopping && next < order.size() && static_cast<int>(running.size()) < at_once) {
      const std::size_t job = order[next++];
      running[start(jobs[job])] = job;
    }
    if (running.empty()) break;
    // A signal does not end a wait, so each wait is short.
    std::vector<std::pair<std::size_t, int>> gone;
    for (const auto& [process, job] : running)
      if (int status = 0; ::waitpid(process, &status, WNOHANG) == process) gone.emplace_back(job, status);
    std::erase_if(running, [&](const auto& entry) {
      return std::any_of(gone.begin(), gone.end(), [&](const auto& end) { return end.first == entry.second; });
    });
    for (const auto& [job, status] : gone) ended(job, end_of(jobs[job], status, stopping));
    if (gone.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  for (; next < order.size(); ++next) ended(order[next], {});
}

}  // namespace berm::jobs
