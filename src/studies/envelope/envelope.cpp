// SPDX-License-Identifier: BSD-3-Clause
#include "envelope/envelope.hpp"

#include "envelope/envelope_report.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/duration_text.hpp"
#include "io/tell.hpp"
#include "simulation/simulate.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::envelope {
namespace {

namespace fs = std::filesystem;

}  // namespace

jobs::Outcome find_envelope(const EnvelopeRequest& request)
{
  const problem::Case settings = jobs::with_whole_paths(request.settings, request.case_file);
  std::vector<EnvelopeRow> rows;
  for (const Probe& probe : choose_probes(settings, request.how)) rows.push_back({probe, "finished", {}});
  if (!user_law::names_library(settings.material))  // a probe loads it, in its sandbox
    simulation::check_buildable(
        {.settings = rows[0].probe.settings, .case_file = request.case_file, .folder = request.folder, .places = request.places});

  io::make_folder(request.folder);
  const fs::path runs = io::make_inner_folder(request.folder, "runs");
  std::vector<jobs::Job> jobs;
  std::vector<std::size_t> row_of_job;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Probe& probe = rows[k].probe;
    jobs::Job job{runs / (probe.name + ".toml"), {}, io::make_inner_folder(runs, probe.name)};
    io::write_atomically(job.case_file, input::resolved_toml(probe.settings));
    if (has_ended_with_result(job)) continue;
    job.resume = goes_on(job);
    jobs.push_back(job);
    row_of_job.push_back(k);
  }
  if (const std::size_t there = rows.size() - jobs.size(); there > 0)
    io::tell("{} of {} probes have their result already and are not run again\n", there, rows.size());
  std::size_t done = 0, failed = 0, interrupted = 0, queued = 0;
  run_jobs(jobs, request.runner, request.folder / "queue", [&](std::size_t job, const jobs::JobEnd& end) {
    EnvelopeRow& row = rows[row_of_job[job]];
    if (outcome_of(end.kind) == jobs::Outcome::unfinished) {
      const bool waits = end.kind == jobs::JobEnd::Kind::queued;
      row.state = waits ? "queued" : "interrupted";
      ++(waits ? queued : interrupted);
      return;
    }
    const bool fails = end.kind == jobs::JobEnd::Kind::failed;
    failed += fails;
    if (fails) row.state = "failed";
    io::tell("{}/{} {}: {}\n", ++done, jobs.size(), row.probe.name,
             fails ? "FAILED: " + end.reason : io::duration_text(jobs::wall_time_of(jobs[job].folder)));
  });
  const base::EmbeddedBody body = embedded_body(settings);
  for (EnvelopeRow& row : rows)
    if (row.state == "finished") row.result = result_of(row.probe, run_folder::read_history(runs / row.probe.name / "history.csv"), body);
  write_envelope_report(settings, rows, request.folder);
  fmt::print("{}", envelope_words(settings, rows));
  if (failed > 0) io::tell("{} of {} probes failed; envelope.csv says which\n", failed, rows.size());
  const std::size_t ended = rows.size() - interrupted - queued;
  if (interrupted > 0) io::tell("interrupted: {} of {} probes are done; the same command goes on from there\n", ended, rows.size());
  if (queued > 0) io::tell("queued: {} of {} probes are done; the same command collects the others\n", ended, rows.size());
  io::tell("the envelope is in {}\n", request.folder.string());
  return interrupted + queued > 0 ? jobs::Outcome::unfinished : failed > 0 ? jobs::Outcome::failed : jobs::Outcome::done;
}

}  // namespace berm::envelope
