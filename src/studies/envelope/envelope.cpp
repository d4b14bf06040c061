// SPDX-License-Identifier: BSD-3-Clause
#include "envelope/envelope.hpp"

#include "envelope/envelope_report.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/batch.hpp"
#include "simulation/simulate.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::envelope {
namespace {

namespace fs = std::filesystem;

/// As envelope.csv says it.
const char* state_of(jobs::JobEnd::Kind kind)
{
  switch (kind) {
  case jobs::JobEnd::Kind::finished:
    return "finished";
  case jobs::JobEnd::Kind::failed:
    return "failed";
  case jobs::JobEnd::Kind::queued:
    return "queued";
  case jobs::JobEnd::Kind::interrupted:
    break;
  }
  return "interrupted";
}

}  // namespace

jobs::Outcome find_envelope(const EnvelopeRequest& request)
{
  const settings::Case settings = jobs::with_whole_paths(request.settings, request.case_file);
  std::vector<EnvelopeRow> rows;
  for (const Probe& probe : choose_probes(settings, request.how)) rows.push_back({probe, "finished", {}});
  if (!user_law::names_library(settings.material))  // a probe loads it, in its sandbox
    simulation::check_buildable(
        {.settings = rows[0].probe.settings, .case_file = request.case_file, .folder = request.folder, .places = request.places});

  io::make_folder(request.folder);
  const fs::path runs = io::make_inner_folder(request.folder, "runs");
  jobs::Batch batch{.what = "probes"};
  for (const EnvelopeRow& row : rows) {
    const jobs::Job job{runs / (row.probe.name + ".toml"), {}, io::make_inner_folder(runs, row.probe.name)};
    io::write_atomically(job.case_file, input::resolved_toml(row.probe.settings));
    batch.jobs.push_back(job);
    batch.names.push_back(row.probe.name);
  }
  run_batch(batch, request.runner, request.folder / "queue");
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].state = state_of(batch.ends[k].kind);
  const base::EmbeddedBody body = embedded_body(settings);
  for (EnvelopeRow& row : rows)
    if (row.state == "finished") row.result = result_of(row.probe, run_folder::read_history(runs / row.probe.name / "history.csv"), body);
  write_envelope_report(settings, rows, request.folder);
  fmt::print("{}", envelope_words(settings, rows));
  if (const std::size_t failed = batch.count(jobs::JobEnd::Kind::failed); failed > 0)
    io::tell("{} of {} probes failed; envelope.csv lists them\n", failed, rows.size());
  tell_of_rest(batch);
  io::tell("the envelope is in {}\n", request.folder.string());
  return batch.outcome();
}

}  // namespace berm::envelope
