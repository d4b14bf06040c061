// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "jobs/processes.hpp"

#include "input/read_case.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "io/scratch_folder.hpp"
#include "io/tell.hpp"
#include "jobs/thread_shares.hpp"
#include "os/child_process.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/mesh_cache.hpp"
#include "os/threads.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

/// Starts the job on these processors, all where there are none, which is asked to stop where this program ends before it.
ChildProcess start(const Job& job, const std::vector<int>& processors)
{
  std::vector<std::string> words = words_of(job);
  words.insert(words.begin(), "berm");
  io::make_folder(job.folder.parent_path());
  try {
    return ChildProcess(
        {.words = words, .program = "/proc/self/exe", .messages = messages_of(job).string(), .processors = processors, .end_by = SIGTERM});
  } catch (const std::system_error& error) {
    throw RunError(fmt::format("no process can be started: {}", error.code().message()));
  }
}

JobEnd end_of(const Job& job, int status, bool stopped)
{
  const JobEnd end = end_with(job, status);
  std::error_code ignored;
  if (end.kind == JobEnd::Kind::finished) fs::remove(messages_of(job), ignored);
  return end.kind == JobEnd::Kind::failed && stopped ? JobEnd{} : end;
}

/// Of a case that cannot be read the job itself says so.
int most_threads_of(const Job& job)
{
  try {
    return !job.is_run() ? 1 : threads_worth(input::read_case(job.case_file, job.set));
  } catch (const InputError&) {
    return 1;
  }
}

/// Jobs that have not begun, the longest first. One into whose folder another process still writes, as a run does whose parent was killed, waits for it, and then goes
/// on from what that left.
class Waiting {
public:
  Waiting(const std::vector<Job>& jobs, const Ended& ended) : jobs_(jobs), ended_(ended), order_(by_time(jobs)) {}

  bool empty() const { return order_.empty(); }
  std::size_t count() const { return order_.size(); }
  /// The next one that can be started, and what to start for it; empty where there is none now.
  std::optional<std::pair<std::size_t, Job>> take()
  {
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::size_t number = order_[k];
      if (is_in_use(number)) continue;
      order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(k--));
      Job job = jobs_[number];
      if (waited_.count(number) > 0 && job.is_run()) {
        if (has_result(job)) {
          ended_(number, end_of(job, status_of(Outcome::done), false));
          continue;
        }
        job.resume = goes_on(job);
      }
      return std::pair{number, job};
    }
    return std::nullopt;
  }
  void tell_of_rest() const
  {
    for (const std::size_t job : order_) ended_(job, {});
  }

private:
  bool is_in_use(std::size_t job)
  {
    const std::string owner = io::FolderLock::owner_of(jobs_[job].folder);
    if (!owner.empty() && waited_.insert(job).second) io::tell("{}: waits for {}, which writes there\n", jobs_[job].folder.string(), owner);
    return !owner.empty();
  }

  const std::vector<Job>& jobs_;
  const Ended& ended_;
  std::vector<std::size_t> order_;
  std::set<std::size_t> waited_;
};

}  // namespace

void run_processes(const std::vector<Job>& jobs, int at_once, const Ended& ended)
{
  const io::ScratchFolder scratch;
  const MeshCache meshes(scratch.path());
  std::map<std::size_t, ChildProcess> running;
  Waiting waiting(jobs, ended);
  ThreadShares shares(at_once, processors());
  bool stopping = false;
  while (true) {
    if (interrupted() && !stopping) {
      for (const auto& entry : running) entry.second.send(SIGTERM);
      stopping = true;
    }
    while (!stopping && shares.any_free()) {
      const int threads = shares.for_next(waiting.count());
      std::optional<std::pair<std::size_t, Job>> next = waiting.take();
      if (!next) break;
      auto& [number, job] = *next;
      job.threads = threads > 1 ? std::min(threads, most_threads_of(job)) : 1;
      running.emplace(number, start(job, shares.begin(number, job.threads)));
    }
    if (running.empty() && (stopping || waiting.empty())) break;
    // A signal does not end a wait, so each wait is short.
    std::vector<std::pair<std::size_t, int>> gone;
    for (auto& [job, process] : running)
      if (process.has_ended()) gone.emplace_back(job, process.wait());
    for (const auto& [job, status] : gone) running.erase(job), shares.end(job);
    for (const auto& [job, status] : gone) ended(job, end_of(jobs[job], status, stopping));
    if (gone.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  waiting.tell_of_rest();
}

}  // namespace berm::jobs
