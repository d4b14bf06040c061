// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/slurm.hpp"

#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/queue_scripts.hpp"
#include "jobs/scheduler.hpp"
#include "jobs/shell.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <unistd.h>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

constexpr const char* before_number = "slurm ";
constexpr int refusals_in_a_row = 20;  // of squeue, some minutes: its server may be restarted

std::size_t tasks_of(const Slurm& slurm, std::size_t count)
{
  const auto pack = static_cast<std::size_t>(slurm.pack);
  return (count + pack - 1) / pack;
}

class SlurmScheduler final : public Scheduler {
public:
  explicit SlurmScheduler(Slurm slurm) : slurm_(std::move(slurm)) {}

  std::string submit(const fs::path& queue, std::size_t count) override
  {
    std::string script = task_script;
    script.replace(script.find("pack=PACK") + 5, 4, std::to_string(slurm_.pack));
    io::write_atomically(queue / "task.sh", script);
    const ShellEnd end = run_shell(sbatch_command(slurm_, queue, count));
    const std::string job = job_number_in(end.out);
    if (end.status != 0 || job.empty()) {
      const std::string why = last_line(end.out);
      const bool many = tasks_of(slurm_, count) > 1000;
      throw RunError(fmt::format("--runner slurm: sbatch refuses the {} runs: {}{}", count,
                                 why.empty() ? fmt::format("it ended with status {}", end.status) : why,
                                 many ? "; of so many put several into a task by --pack" : ""));
    }
    return before_number + job;
  }

  bool works_on(const std::string& handle) override
  {
    if (handle.empty()) return false;
    const std::string job = number_of(handle);
    const ShellEnd end =
        run_shell(fmt::format("env -u SQUEUE_STATES -u SQUEUE_PARTITION squeue --noheader --format=%F --user={}", ::getuid()));
    if (interrupted()) return true;  // Ctrl-C reaches squeue, too
    if (end.status != 0) {
      if (++refusals_ < refusals_in_a_row) return true;
      throw RunError(
          fmt::format("squeue does not say whether Slurm's job {} is done: {}; the same command asks again", job, last_line(end.out)));
    }
    refusals_ = 0;
    std::istringstream words(end.out);
    for (std::string word; words >> word;)
      if (word == job) return true;
    return false;
  }

  void leave(const std::string& handle) override
  {
    const std::string job = number_of(handle);
    io::tell("Slurm keeps the runs that are not done (job {0}): the same command waits for them again, scancel {0} cancels them\n", job);
  }

  Real pause(Real waited) const override { return std::clamp<Real>(waited / 20, 0.5, 10); }

private:
  static std::string number_of(const std::string& handle)
  {
    if (!handle.starts_with(before_number))
      throw RunError(fmt::format("the runs were submitted to a {}: collect them by the same --runner, or remove the folder queue", handle));
    return handle.substr(std::string(before_number).size());
  }

  Slurm slurm_;
  int refusals_ = 0;
};

}  // namespace

std::string sbatch_command(const Slurm& slurm, const fs::path& queue, std::size_t count)
{
  return fmt::format("env -u SLURM_CPUS_PER_TASK sbatch --parsable --array=0-{}{} --chdir={} {} {}", tasks_of(slurm, count) - 1,
                     slurm.at_once > 0 ? fmt::format("%{}", slurm.at_once) : "", quoted(queue.string()), slurm.options,
                     quoted((queue / "task.sh").string()));
}

std::string job_number_in(const std::string& said)
{
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    if (digits > 0 && (digits == line.size() || line[digits] == ';')) return line.substr(0, digits);  // NUMBER or NUMBER;CLUSTER
  }
  return "";
}

std::unique_ptr<Scheduler> scheduler_for(const Slurm& slurm)
{
  return std::make_unique<SlurmScheduler>(slurm);
}

}  // namespace berm::jobs
