// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "jobs/jobs.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "run_folder/build.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <numeric>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

constexpr Real time_of_fast = 5;  // s, where no earlier run tells it

fs::path messages_of(const Job& job)
{
  return job.folder.string() + ".messages";
}

std::vector<std::string> words_of(const Job& job)
{
  if (job.resume) return {"berm", "run", "--resume", job.folder.string(), "--threads", "1"};
  std::vector<std::string> words = {"berm", job.element ? "element" : "run", job.case_file.string(), "-o", job.folder.string(), "--force"};
  if (!job.element) words.insert(words.end(), {"--threads", "1"});
  if (job.uncertainty) words.emplace_back("--uncertainty");
  for (const std::string& set : job.set) words.insert(words.end(), {"--set", set});
  return words;
}

/// Starts the job and returns its process, which gets signals from this program alone and is asked to stop when this program
/// ends.
pid_t start(const Job& job)
{
  std::vector<std::string> words = words_of(job);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  io::make_folder(job.folder.parent_path());
  const fs::path messages = messages_of(job);
  const int out = ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (out < 0) io::throw_errno(fmt::format("cannot write {}", messages.string()));
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

/// The last line that a process wrote, without the program's name.
std::string last_message(const fs::path& file)
{
  std::ifstream lines(file);
  std::string line, last;
  while (std::getline(lines, line))
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  return last.starts_with("berm: ") ? last.substr(6) : last;
}

JobEnd end_of(const Job& job, int status, bool stopped)
{
  const fs::path messages = messages_of(job);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    std::error_code ignored;
    fs::remove(messages, ignored);
    return {JobEnd::Kind::finished, ""};
  }
  if (stopped || (WIFEXITED(status) && WEXITSTATUS(status) == status_of(Outcome::unfinished))) return {JobEnd::Kind::interrupted, ""};
  if (WIFSIGNALED(status))
    return {JobEnd::Kind::failed, fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)))};
  const std::string last = last_message(messages);
  return {JobEnd::Kind::failed, last.empty() ? fmt::format("ended with status {} without a message", WEXITSTATUS(status)) : last};
}

/// Empty where it is damaged, too: the case is then run again.
std::optional<run_folder::RunSummary> summary_if_whole(const fs::path& folder)
{
  try {
    return run_folder::read_summary(folder);
  } catch (const RunError&) {
    return std::nullopt;
  }
}

/// Whether a summary is of the case of the job, by this build.
bool is_of_this(const Job& job, const run_folder::RunSummary& summary)
{
  const problem::Case settings = input::read_case(job.case_file, job.set);
  if (!run_folder::by_this_build(summary, settings.method)) return false;
  const std::string found = io::read_text_file(job.folder / "resolved.toml"), asked = input::resolved_toml(settings);
  return input::without_report(found) == input::without_report(asked);
}

/// The numbers of the jobs, the longest first.
std::vector<std::size_t> by_time(const std::vector<Job>& jobs)
{
  std::vector<Real> times;
  for (const Job& job : jobs) {
    const Real earlier = wall_time_of(job.folder);
    times.push_back(!std::isnan(earlier) ? earlier : job.fast ? time_of_fast : infinity);
  }
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] > times[b]; });
  return order;
}

}  // namespace

void run_jobs(const std::vector<Job>& jobs, int at_once, const std::function<void(std::size_t, const JobEnd&)>& ended)
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

bool has_result(const Job& job)
{
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(job.folder);
  return summary && summary->finished() && is_of_this(job, *summary);
}

bool goes_on(const Job& job)
{
  std::error_code error;
  if (job.element || !fs::exists(job.folder / "checkpoint/case_file.txt", error)) return false;
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(job.folder);
  return summary && !summary->finished() && is_of_this(job, *summary);
}

Real wall_time_of(const fs::path& folder)
{
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(folder);
  const std::map<std::string, Real> timing = summary ? summary->timing : std::map<std::string, Real>();
  const auto wall = timing.find("wall_s");
  return wall == timing.end() ? std::numeric_limits<Real>::quiet_NaN() : wall->second;
}

}  // namespace berm::jobs
