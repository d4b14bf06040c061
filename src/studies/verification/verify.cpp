// SPDX-License-Identifier: BSD-3-Clause
#include "verification/verify.hpp"

#include "core/error.hpp"
#include "element/element_settings.hpp"
#include "input/read_case.hpp"
#include "verification/requirements.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

void print(const std::vector<Row>& rows)
{
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const Row& row : rows)
    for (std::size_t k = 0; k + 1 < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  for (const Row& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool last = k + 1 == row.size();
      fmt::print("{:<{}}{}", row[k], last ? 0 : widths[k], last ? "\n" : "  ");
    }
}

/// The runs of an example as jobs, in their order. Throws InputError where a case cannot be read.
void add_jobs(std::vector<jobs::Job>& jobs, const Example& example, const fs::path& output)
{
  for (const auto& [name, run] : example.runs) {
    const fs::path file = example.folder / run.case_file;
    try {
      if (run.element)
        element::read_element_case(file, run.set);
      else
        input::read_case(file, run.set);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: run.{}: {}", (example.folder / "expected.toml").string(), name, error.what()));
    }
    jobs.push_back({file, run.set, output / example.name / name, run.fast, run.uncertainty, run.element});
  }
}

/// Tells of each job as it ends.
class Teller {
public:
  explicit Teller(std::size_t count) : count_(count) {}
  void tell(const std::string& problem, const jobs::JobEnd& end, Real wall)
  {
    if (outcome_of(end.kind) == jobs::Outcome::unfinished) return;
    const std::string words = end.kind == jobs::JobEnd::Kind::failed ? "FAILED: " + end.reason : fmt::format("{:.1f} s", wall);
    fmt::print(stderr, "{:>{}}/{} {}: {}\n", ++done_, fmt::formatted_size("{}", count_), count_, problem, words);
  }
  std::size_t done() const { return done_; }

private:
  std::size_t count_, done_ = 0;
};

}  // namespace

void list_problems(const ProblemChoice& choice)
{
  std::vector<Row> rows = {{"problem", "", "numbers", "title"}};
  for (const Example& example : find_problems(choice))
    for (const auto& [name, run] : example.runs) {
      const auto is_about = [&, &own = name](const Expectation& e) {
        const std::vector<std::string> runs = runs_of(e);
        return std::find(runs.begin(), runs.end(), own) != runs.end();
      };
      const auto count = std::count_if(example.expectations.begin(), example.expectations.end(), is_about);
      rows.push_back({example.name + "/" + name, run.fast ? "fast" : "", std::to_string(count), run.title});
    }
  print(rows);
}

void list_requirements(const ProblemChoice& choice, const fs::path& output)
{
  std::vector<Chapter> chapters;
  for (const Example& example : find_problems(choice)) {
    Chapter& chapter = chapters.emplace_back(Chapter{example, {}, {}});
    for (const auto& entry : example.runs) {
      const fs::path folder = output / example.name / entry.first;
      std::error_code error;
      const bool done = fs::exists(folder / "summary.json", error);
      chapter.results.push_back({folder, {done ? jobs::JobEnd::Kind::finished : jobs::JobEnd::Kind::interrupted, ""}});
    }
    for (const Expectation& e : example.expectations) chapter.findings.push_back(compare_with_expectation(example, e, chapter.results));
  }
  fmt::print("{}", requirements_text(chapters));
}

jobs::Outcome verify(const VerifyRequest& request)
{
  const std::vector<Example> examples = find_problems(request.choice);
  std::vector<jobs::Job> jobs;
  for (const Example& example : examples) add_jobs(jobs, example, request.output);

  std::vector<ProblemResult> results;
  for (jobs::Job& job : jobs) {
    job.resume = goes_on(job);
    results.push_back({job.folder, {}});
  }
  Teller teller(jobs.size());
  run_jobs(jobs, request.runner, request.output / "queue", [&](std::size_t job, const jobs::JobEnd& end) {
    results[job].end = end;
    teller.tell(fs::relative(jobs[job].folder, request.output).string(), end, jobs::wall_time_of(jobs[job].folder));
  });

  std::vector<Row> rows = {{"problem", "quantity", "exact", "berm", "error", "tolerance", "verdict", "source"}};
  std::vector<Chapter> chapters;
  bool all_met = true;
  auto first = results.begin();
  for (const Example& example : examples) {
    const auto last = first + static_cast<std::ptrdiff_t>(example.runs.size());
    Chapter& chapter = chapters.emplace_back(Chapter{example, {first, last}, {}});
    first = last;
    for (const ProblemResult& result : chapter.results) all_met = all_met && result.end.kind == jobs::JobEnd::Kind::finished;
    for (const Expectation& e : example.expectations) {
      const ExpectationResult& f = chapter.findings.emplace_back(compare_with_expectation(example, e, chapter.results));
      rows.push_back(
          {f.problem, f.what, f.exact, f.berm, f.error, f.tolerance, word_of(f.verdict), f.reason.empty() ? e.source : f.reason});
      all_met = all_met && f.verdict == Verdict::met;
    }
  }
  print(rows);
  std::fflush(stdout);
  const bool queued = std::any_of(results.begin(), results.end(),
                                  [](const ProblemResult& result) { return result.end.kind == jobs::JobEnd::Kind::queued; });
  if (teller.done() < jobs.size())
    fmt::print(stderr, "{}: {} of {} problems are done{}\n", queued ? "queued" : "interrupted", teller.done(), jobs.size(),
               queued ? "; the same command collects the others" : "");
  write_book(request.output, chapters);
  fmt::print(stderr, "the book is {}\n", (request.output / "index.html").string());
  if (teller.done() < jobs.size()) return jobs::Outcome::unfinished;
  return all_met ? jobs::Outcome::done : jobs::Outcome::failed;
}

}  // namespace berm::verification
