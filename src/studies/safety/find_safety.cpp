// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/safety/find_safety_test.cpp
#include "safety/find_safety.hpp"

#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/duration_text.hpp"
#include "io/tell.hpp"
#include "jobs/batch.hpp"
#include "os/error.hpp"
#include "run_folder/summary_file.hpp"
#include "safety/safety_report.hpp"
#include "simulation/simulate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::safety {
namespace {

namespace fs = std::filesystem;

jobs::Job job_of(const SafetyRequest& request, const settings::Case& settings, Real factor)
{
  const fs::path runs = request.folder / "runs";
  const std::string name = trial_name(factor);
  jobs::Job job{runs / (name + ".toml"), {}, io::make_inner_folder(runs, name)};
  io::write_atomically(job.case_file, input::resolved_toml(trial_case(settings, factor)));
  return job;
}

/// What a finished run has found.
Trial result_of(Real factor, const fs::path& folder)
{
  Trial trial{factor};
  const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(folder);
  if (!summary) throw RunError(fmt::format("{} has no summary.json", folder.string()));
  const auto check = [&](const char* name) {
    const auto found = summary->checks.find(name);
    return found == summary->checks.end() ? nan : found->second;
  };
  trial.end = check("soil_failed") == 1 ? TrialEnd::fails : check("soil_at_rest") == 1 ? TrialEnd::stands : TrialEnd::undecided;
  trial.movement = check("soil_movement_m");
  trial.limit = check("soil_movement_limit_m");
  trial.time_factor = check("time_factor_of_last_stage");
  trial.wall_s = jobs::wall_time_of(folder);
  if (trial.end == TrialEnd::undecided) trial.why = "it has not failed, and is still moving at the end: give the last stage more time";
  return trial;
}

/// Trials of this case by an earlier command, whatever factors it came to.
std::vector<Trial> earlier_trials(const SafetyRequest& request, const settings::Case& settings)
{
  std::vector<Trial> trials;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(request.folder / "runs", error)) {
    if (entry.path().extension() != ".toml") continue;
    const jobs::Job job{entry.path(), {}, fs::path(entry.path()).replace_extension()};
    try {
      const settings::Case found = input::read_case(job.case_file, {});
      if (!found.safety || !has_result(job)) continue;
      const Real factor = found.safety->factor;
      if (input::resolved_toml(found) == input::resolved_toml(trial_case(settings, factor)))
        trials.push_back(result_of(factor, job.folder));
    } catch (const InputError&) {  // of another version: it is made again where the search comes to it
    }
  }
  return trials;
}

/// The trials of a round, and how they ended together.
struct Round {
  std::vector<Trial> trials;
  jobs::Batch batch;

  bool interrupted() const { return batch.count(jobs::JobEnd::Kind::interrupted) > 0; }
  bool queued() const { return batch.count(jobs::JobEnd::Kind::queued) > 0; }
};

Round run_round(const SafetyRequest& request, const settings::Case& settings, const std::vector<Real>& factors)
{
  Round round;
  for (const Real factor : factors) round.batch.jobs.push_back(job_of(request, settings, factor));
  round.batch.ended = [&](std::size_t job, const jobs::JobEnd& end) {
    if (outcome_of(end.kind) == jobs::Outcome::unfinished) return;
    Trial trial{factors[job]};
    if (end.kind == jobs::JobEnd::Kind::finished)
      trial = result_of(factors[job], round.batch.jobs[job].folder);
    else
      trial.why = "the run failed: " + end.reason;
    io::tell("{}: {}{}\n", trial_name(trial.factor), trial.why.empty() ? word_of(trial.end) : trial.why,
             std::isfinite(trial.wall_s) ? ", " + io::duration_text(trial.wall_s) : "");
    round.trials.push_back(trial);
  };
  run_batch(round.batch, request.runner, request.folder / "queue");
  round.batch.ended = {};  // it refers to this round
  return round;
}

/// Whether the search has found what was asked for, or that F is beyond its limits.
bool tells(const std::vector<Trial>& trials, const SearchSettings& how)
{
  const Bracket bracket = bracket_of(trials);
  const bool narrow = !bracket.stands || !bracket.fails || *bracket.fails - *bracket.stands <= how.tolerance * (1 + 1e-9);
  return (bracket.stands || bracket.fails) && (narrow || bracket.undecided.empty());
}

void sort(std::vector<Trial>& trials)
{
  std::sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.factor < b.factor; });
}

}  // namespace

settings::Case trial_case(settings::Case settings, Real factor)
{
  if (!settings.safety) settings.safety.emplace();
  settings.safety->factor = factor;
  return settings;
}

jobs::Outcome find_safety(const SafetyRequest& request)
{
  const settings::Case settings = jobs::with_whole_paths(request.settings, request.case_file);
  simulation::check_buildable(
      {.settings = trial_case(settings, request.how.low), .case_file = request.case_file, .folder = request.folder});
  io::make_folder(request.folder);
  io::make_inner_folder(request.folder, "runs");
  std::vector<Trial> trials = earlier_trials(request, settings);
  if (!trials.empty()) io::tell("{} trials have their result already and are not run again\n", trials.size());
  Round last;
  while (!last.interrupted() && !last.queued()) {
    const std::vector<Real> factors = next_factors(trials, request.how);
    if (factors.empty()) break;
    last = run_round(request, settings, factors);
    trials.insert(trials.end(), last.trials.begin(), last.trials.end());
  }
  sort(trials);
  write_safety_report(settings, trials, request.folder, !last.interrupted() && !last.queued());
  fmt::print("{}", safety_words(trials));
  for (const std::string& doubt : doubts_of(trials, settings.method)) io::tell("warning: {}\n", doubt);
  if (last.interrupted()) io::tell("interrupted: the same command continues\n");
  if (last.queued()) io::tell("queued: the same command collects the trials and continues\n");
  io::tell("the factor of safety is in {}\n", (request.folder / "safety.html").string());
  if (last.interrupted() || last.queued()) return jobs::Outcome::unfinished;
  return tells(trials, request.how) ? jobs::Outcome::done : jobs::Outcome::failed;
}

}  // namespace berm::safety
