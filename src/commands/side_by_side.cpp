// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/side_by_side.hpp"

#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/jobs.hpp"
#include "structures/after_run/after_run.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

void print_results(const simulation::RunRequest& request)
{
  if (const std::string table = after_run::key_results_in(request); !table.empty()) fmt::print("{}\n", table);
}

}  // namespace

std::filesystem::path queue_of(const std::vector<simulation::RunRequest>& requests)
{
  return requests.front().folder.string() + ".queue";
}

jobs::Outcome run_side_by_side(const std::vector<simulation::RunRequest>& requests, const CaseOptions& options, bool with_bands)
{
  const jobs::Runner runner = options.runner();
  const bool local = std::holds_alternative<jobs::LocalProcesses>(runner.by);
  std::vector<jobs::Job> jobs;
  std::vector<simulation::RunRequest> of_job;
  for (const simulation::RunRequest& request : requests) {
    const jobs::Job job{request.case_file, options.overrides, request.folder, nan, options.uncertainty && with_bands};
    if (!local && !options.force && has_result(job)) {
      io::tell("{} has its result already and is not run again\n", request.folder.string());
      print_results(request);
      continue;
    }
    jobs.push_back(job);
    of_job.push_back(request);
  }
  jobs::Outcome outcome = jobs::Outcome::done;
  run_jobs(jobs, runner, queue_of(requests), [&](std::size_t job, const jobs::JobEnd& end) {
    const simulation::RunRequest& request = of_job[job];
    outcome = worse(outcome, jobs::outcome_of(end.kind));
    if (end.kind == jobs::JobEnd::Kind::queued) {
      io::tell("{}: queued; the same command collects it\n", request.case_file.string());
      return;
    }
    io::tell("{}", io::read_text_file(request.folder / "run.log"));
    if (end.kind == jobs::JobEnd::Kind::finished)
      print_results(request);
    else
      io::tell("berm: {}: {}\n", request.case_file.string(),
               end.kind == jobs::JobEnd::Kind::interrupted ? "stopped, or not begun" : end.reason);
  });
  return outcome;
}

}  // namespace berm::commands
