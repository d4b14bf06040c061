// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/jobs.hpp"

#include "io/tell.hpp"
#include "jobs/processes.hpp"
#include "jobs/queue.hpp"
#include "jobs/scheduler.hpp"
#include "jobs/shell.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <thread>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;
using Kind = JobEnd::Kind;

/// A wait that Ctrl-C ends.
void wait_for(Real seconds)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<Real>(seconds);
  while (!interrupted() && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

/// Hands over what has not ended, unless an earlier command did and it is still at work. Whether any job is.
bool hand_over(Queue& queue, Scheduler& scheduler)
{
  if (scheduler.works_on(queue.handle())) {
    queue.check_holds_all();
    io::tell("the runs of {} were submitted by an earlier command\n", queue.folder().string());
    return true;
  }
  const std::vector<std::size_t> to_do = queue.to_do();
  if (to_do.empty()) return false;
  queue.write(to_do);
  const std::string handle = scheduler.submit(queue.folder(), to_do.size());
  queue.hand_to(handle);
  io::tell("{} run{} submitted to {}; {} has their commands\n", to_do.size(), to_do.size() == 1 ? " is" : "s are", handle,
           queue.folder().string());
  return true;
}

/// Tells of jobs as they end, each once.
class ProgressPrinter {
public:
  ProgressPrinter(const Queue& queue, std::size_t count, const Ended& ended) : queue_(queue), told_(count, false), ended_(ended) {}

  /// Whether all have been told of.
  bool tell()
  {
    for (std::size_t k = 0; k < told_.size(); ++k)
      if (!told_[k])
        if (const std::optional<JobEnd> end = queue_.end_of(k)) tell(k, *end);
    return std::find(told_.begin(), told_.end(), false) == told_.end();
  }
  /// The rest, of which it is known whether anybody works on them. Whether all have ended.
  bool tell_rest(bool at_work)
  {
    bool all = true;
    for (std::size_t k = 0; k < told_.size(); ++k) {
      if (told_[k]) continue;
      tell(k, at_work ? JobEnd{Kind::queued, ""} : queue_.left_over(k));
      all = all && queue_.end_of(k);
    }
    return all;
  }

private:
  void tell(std::size_t job, const JobEnd& end)
  {
    told_[job] = true;
    ended_(job, end);
  }

  const Queue& queue_;
  std::vector<bool> told_;
  const Ended& ended_;
};

void run_by(Scheduler& scheduler, const std::vector<Job>& jobs, bool wait, const fs::path& folder, const Ended& ended)
{
  Queue queue(folder, jobs);
  ProgressPrinter printer(queue, jobs.size(), ended);
  bool at_work = hand_over(queue, scheduler), all_told = false;
  for (Real waited = 0; true;) {
    // Asked before the folders are looked at, so that what ends in between is not missed.
    at_work = at_work && scheduler.works_on(queue.handle());
    all_told = printer.tell();
    if (all_told || !at_work || !wait || interrupted()) break;
    const Real pause = scheduler.pause(waited);
    wait_for(pause);
    waited += pause;
  }
  if (at_work && !all_told && interrupted()) {
    scheduler.leave(queue.handle());
    at_work = scheduler.works_on(queue.handle());
  }
  if (const std::string why = scheduler.complaint(); !why.empty() && !all_told && (queue.none_has_begun() || (!wait && !interrupted()))) {
    queue.close();
    throw RunError(why);
  }
  if (printer.tell_rest(at_work))
    queue.close();
  else if (!at_work)
    queue.hand_to("");
}

/// Runs that were handed over may be at work elsewhere, and two programs must not do the same.
void refuse_while_open(const fs::path& folder)
{
  if (const std::string handle = Queue(folder, {}).handle(); !handle.empty())
    throw RunError(
        fmt::format("{} says that the runs were submitted ({}): collect them by the same command with its --runner, or cancel them "
                    "and remove that folder",
                    folder.string(), handle));
}

}  // namespace

void check_runner(const Runner& runner)
{
  if (const auto* command = std::get_if<ShellCommand>(&runner.by);
      command != nullptr && command->command.find("{jobs}") == std::string::npos)
    throw InputError(
        fmt::format("--runner \"{}\" is neither slurm nor a command with {{jobs}}, which stands for the file with one command per line",
                    command->command));
  if (std::holds_alternative<Slurm>(runner.by) && !has_program("sbatch"))
    throw InputError("--runner slurm: there is no sbatch in PATH: this machine does not submit jobs to Slurm");
  if (std::holds_alternative<LocalProcesses>(runner.by) && !runner.wait)
    throw InputError("--no-wait requires --runner: the processes of this machine end with the command that starts them");
}

bool handed_over(const fs::path& queue)
{
  std::error_code error;
  return fs::exists(queue / "open", error);
}

void run_jobs(const std::vector<Job>& jobs, const Runner& runner, const fs::path& queue, const Ended& ended)
{
  if (const auto* local = std::get_if<LocalProcesses>(&runner.by)) {
    refuse_while_open(queue);
    return run_processes(jobs, local->at_once, ended);
  }
  const auto* command = std::get_if<ShellCommand>(&runner.by);
  const std::unique_ptr<Scheduler> scheduler =
      command != nullptr ? scheduler_for(*command, runner.wait) : scheduler_for(std::get<Slurm>(runner.by));
  run_by(*scheduler, jobs, runner.wait, queue, ended);
}

}  // namespace berm::jobs
