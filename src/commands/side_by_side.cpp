// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/side_by_side.hpp"

#include "io/atomic_file.hpp"
#include "jobs/jobs.hpp"
#include "simulation/resume.hpp"

#include <fmt/format.h>

namespace berm::commands {

jobs::Outcome run_side_by_side(const std::vector<simulation::RunRequest>& requests, const std::vector<std::string>& overrides, int at_once)
{
  std::vector<jobs::Job> jobs;
  for (const simulation::RunRequest& request : requests) jobs.push_back({request.case_file, overrides, request.folder});
  jobs::Outcome outcome = jobs::Outcome::done;
  run_jobs(jobs, at_once, [&](std::size_t job, const jobs::JobEnd& end) {
    const simulation::RunRequest& request = requests[job];
    fmt::print(stderr, "{}", io::read_text_file(request.folder / "run.log"));
    if (end.kind == jobs::JobEnd::Kind::finished) {
      if (const std::string table = simulation::key_results_in(request); !table.empty()) fmt::print("{}\n", table);
      return;
    }
    outcome = worse(outcome, jobs::outcome_of(end.kind));
    fmt::print(stderr, "berm: {}: {}\n", request.case_file.string(),
               end.kind == jobs::JobEnd::Kind::interrupted ? "stopped, or not begun" : end.reason);
  });
  return outcome;
}

}  // namespace berm::commands
