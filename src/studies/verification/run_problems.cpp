// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_resume_test.cpp
#include "verification/run_problems.hpp"

#include "cyclic/cyclic_settings.hpp"
#include "element/element_report.hpp"
#include "input/read_case.hpp"
#include "io/duration_text.hpp"
#include "io/tell.hpp"
#include "jobs/batch.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "route/route_settings.hpp"
#include "run_folder/build.hpp"
#include "sea/sea_settings.hpp"
#include "simulation/simulate.hpp"
#include "soil_fit/fit_settings.hpp"
#include "uncertainty/variants.hpp"
#include "verification/remaining.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;
using Kind = jobs::JobEnd::Kind;

constexpr Real time_of_fast = 5;  // s, of fast problems, and of what is no run

bool holds(const jobs::Job& job)
{
  if (!job.is_run() && job.command != "element") return false;  // its tests or contours may be others
  return job.command == "element" ? element::has_result(element::read_element_case(job.case_file, job.set), job.folder)
                                  : jobs::has_result(job);
}

/// s, NaN where it is not known: the job then says itself what is wrong.
Real estimate_of(const jobs::Job& job)
{
  try {
    const settings::Case c = input::read_case(job.case_file, job.set);
    const Real run = simulation::expected_wall_time({.settings = c, .case_file = job.case_file, .folder = job.folder});
    return job.uncertainty ? run * (1 + work_of(uncertainty::choose_variants(c), c)) : run;
  } catch (const std::exception&) {
    return nan;
  }
}

/// What berm check tells, for the jobs of which no earlier run does.
void estimate_times(std::vector<jobs::Job>& jobs)
{
  std::vector<jobs::Job*> unknown;
  for (jobs::Job& job : jobs)
    if (std::isnan(expected_time(job))) unknown.push_back(&job);
  if (unknown.empty()) return;
  io::tell("estimating the time of {} problem{}\n", unknown.size(), unknown.size() == 1 ? "" : "s");
  for (jobs::Job* job : unknown) {
    if (interrupted()) return;
    job->estimate = estimate_of(*job);
  }
}

/// Its result and checkpoint, but not the time that it took.
void remove_result(jobs::Job& job)
{
  job.estimate = expected_time(job);
  std::error_code ignored;
  for (const char* name : {"summary.json", "checkpoint"}) fs::remove_all(job.folder / name, ignored);
}

/// Tells how far the jobs are.
class ProgressPrinter {
public:
  ProgressPrinter(const std::vector<jobs::Job>& jobs, const jobs::Runner& runner, fs::path output)
      : jobs_(jobs),
        output_(std::move(output)),
        begin_(Clock::now())
  {
    if (const auto* local = std::get_if<jobs::LocalProcesses>(&runner.by)) remaining_.emplace(jobs, local->at_once);
    io::tell("{} problem{} to run{}\n", jobs.size(), jobs.size() == 1 ? "" : "s", words_of_time("; about {}"));
  }
  /// Of the job in this folder.
  void tell(const fs::path& folder, const jobs::JobEnd& end)
  {
    const auto job = static_cast<std::size_t>(std::ranges::find(jobs_, folder, &jobs::Job::folder) - jobs_.begin());
    if (outcome_of(end.kind) == jobs::Outcome::unfinished) return;
    if (remaining_) remaining_->end(job, end.kind == Kind::finished, now());
    ++done_;
    const std::string words = end.kind == Kind::failed ? "FAILED: " + end.reason : io::duration_text(jobs::wall_time_of(folder));
    io::tell("{:>{}}/{} {}: {}{}\n", done_, fmt::formatted_size("{}", jobs_.size()), jobs_.size(), fs::relative(folder, output_).string(),
             words, words_of_rest());
  }

private:
  using Clock = std::chrono::steady_clock;

  Real now() const { return std::chrono::duration<Real>(Clock::now() - begin_).count(); }
  /// "" where it is not known.
  std::string words_of_time(fmt::format_string<std::string> words) const
  {
    const Real rest = remaining_ ? remaining_->seconds(now()) : nan;
    return rest > 0 ? fmt::format(words, io::duration_text(rest)) : "";
  }
  std::string words_of_rest() const
  {
    if (!remaining_ || done_ == jobs_.size()) return "";
    return fmt::format("  ({} running, {} to begin{})", remaining_->running(), remaining_->waiting(),
                       words_of_time("; about {} to the end"));
  }

  const std::vector<jobs::Job>& jobs_;
  fs::path output_;
  Clock::time_point begin_;
  std::optional<Remaining> remaining_;
  std::size_t done_ = 0;
};

/// Says which results are there already; those of runs that another build of the program recorded are not the newest that can be had.
void tell_of_results(const std::vector<jobs::Job>& there, std::size_t jobs)
{
  if (there.empty()) return;
  std::size_t earlier = 0;
  for (const jobs::Job& job : there) earlier += !run_folder::recorded_by_this_program(*run_folder::read_summary(job.folder));
  fmt::print(
      stderr, "{} of {} problems have their result already and are not run again{}\n", there.size(), jobs,
      earlier == 0 ? "" : fmt::format("; {} of them by the same engine in another build of the program (--force runs them anew)", earlier));
}

}  // namespace

std::vector<jobs::Job> jobs_of(const std::vector<Example>& examples, const fs::path& output)
{
  std::vector<jobs::Job> jobs;
  for (const Example& example : examples)
    for (const auto& [name, run] : example.runs) {
      const fs::path file = example.folder / run.case_file;
      try {
        if (run.fit)
          soil_fit::read_fit_case(file, run.set);
        else if (run.cyclic)
          cyclic::read_cyclic_case(file, run.set);
        else if (run.sea)
          sea::read_sea_case(file, run.set);
        else if (run.route)
          route::read_route_case(file, run.set);
        else if (run.element)
          element::read_element_case(file, run.set);
        else
          input::read_case(file, run.set);
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: run.{}: {}", (example.folder / "expected.toml").string(), name, error.what()));
      }
      jobs.push_back(
          {file, run.set, output / example.name / name, run.fast || !run.is_run() ? time_of_fast : nan, run.uncertainty, run.command()});
    }
  return jobs;
}

std::vector<ProblemResult> run_problems(std::vector<jobs::Job> all, const fs::path& output, const jobs::Runner& runner, bool anew)
{
  if (anew)
    for (jobs::Job& job : all) remove_result(job);
  std::optional<ProgressPrinter> printer;
  jobs::Batch batch{.jobs = std::move(all), .has_result = holds};
  batch.before = [&](const std::vector<jobs::Job>& there, std::vector<jobs::Job>& to_run) {
    tell_of_results(there, batch.jobs.size());
    if (to_run.empty()) return;
    estimate_times(to_run);
    printer.emplace(to_run, runner, output);
  };
  batch.ended = [&](std::size_t job, const jobs::JobEnd& end) { printer->tell(batch.jobs[job].folder, end); };
  run_batch(batch, runner, output / "queue");
  std::vector<ProblemResult> results;
  for (std::size_t k = 0; k < batch.jobs.size(); ++k) results.push_back({batch.jobs[k].folder, batch.ends[k]});
  return results;
}

}  // namespace berm::verification
