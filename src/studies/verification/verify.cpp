// SPDX-License-Identifier: BSD-3-Clause
#include "verification/verify.hpp"

#include "io/duration_text.hpp"
#include "io/tell.hpp"
#include "verification/book_html.hpp"
#include "verification/book_index.hpp"
#include "verification/quoted_pages.hpp"
#include "verification/requirements.hpp"
#include "verification/run_problems.hpp"
#include "verification/trust_page.hpp"

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

/// The results of all examples, compared with what is expected.
std::vector<ExamplePage> pages_of(const std::vector<Example>& examples, const std::vector<ProblemResult>& results)
{
  std::vector<ExamplePage> pages;
  auto first = results.begin();
  for (const Example& example : examples) {
    const auto last = first + static_cast<std::ptrdiff_t>(example.runs.size());
    ExamplePage& page = pages.emplace_back(ExamplePage{example, {first, last}, {}});
    first = last;
    for (const Expectation& e : example.expectations) page.findings.push_back(compare_with_expectation(example, e, page.results));
  }
  return pages;
}

void print_numbers(const std::vector<ExamplePage>& pages)
{
  std::vector<Row> rows = {{"problem", "quantity", "exact", "berm", "error", "tolerance", "verdict", "time", "source"}};
  for (const ExamplePage& page : pages)
    for (std::size_t k = 0; k < page.findings.size(); ++k) {
      const ExpectationResult& f = page.findings[k];
      const ProblemResult* result = result_of(page, page.example.expectations[k].run);
      rows.push_back({f.problem, f.what, f.exact, f.berm, f.error, f.tolerance, word_of(f.verdict),
                      result == nullptr ? "" : time_of(*result), f.reason.empty() ? page.example.expectations[k].source : f.reason});
    }
  print(rows);
}

void print_longest(const std::vector<ExamplePage>& pages)
{
  std::vector<Row> rows = {{"the longest runs", "time"}};
  for (const auto& [problem, wall] : longest_problems(pages)) rows.push_back({problem, io::duration_text(wall)});
  if (rows.size() == 1) return;
  fmt::print("\n");
  print(rows);
}

bool all_met(const std::vector<ExamplePage>& pages)
{
  return std::all_of(pages.begin(), pages.end(), [](const ExamplePage& page) {
    return std::all_of(page.findings.begin(), page.findings.end(), [](const ExpectationResult& f) { return f.verdict == Verdict::met; }) &&
           std::all_of(page.results.begin(), page.results.end(),
                       [](const ProblemResult& result) { return result.end.kind == jobs::JobEnd::Kind::finished; });
  });
}

}  // namespace

void list_problems(const ProblemChoice& choice)
{
  std::vector<Row> rows = {{"chapter", "problem", "", "numbers", "title"}};
  for (const Example& example : find_problems(choice))
    for (const auto& [name, run] : example.runs) {
      const auto is_about = [&, &own = name](const Expectation& e) {
        const std::vector<std::string> runs = runs_of(e);
        return std::find(runs.begin(), runs.end(), own) != runs.end();
      };
      const auto count = std::count_if(example.expectations.begin(), example.expectations.end(), is_about);
      rows.push_back({expectations::chapter_words[static_cast<std::size_t>(example.chapter)], example.name + "/" + name,
                      run.fast      ? "fast"
                      : run.is_long ? "long"
                                    : "",
                      std::to_string(count), run.title});
    }
  print(rows);
}

void list_requirements(const ProblemChoice& choice, const fs::path& output)
{
  const std::vector<Example> examples = find_problems(choice);
  std::vector<ProblemResult> results;
  for (const Example& example : examples)
    for (const auto& entry : example.runs) {
      const fs::path folder = output / example.name / entry.first;
      std::error_code error;
      const bool done = fs::exists(folder / "summary.json", error);
      results.push_back({folder, {done ? jobs::JobEnd::Kind::finished : jobs::JobEnd::Kind::interrupted, ""}});
    }
  fmt::print("{}", requirements_text(pages_of(examples, results)));
}

jobs::Outcome verify(const VerifyRequest& request)
{
  const std::vector<Example> examples = find_problems(request.choice);
  const std::vector<ProblemResult> results = run_problems(jobs_of(examples, request.output), request.output, request.runner, request.anew);
  const std::vector<ExamplePage> pages = pages_of(examples, results);
  print_numbers(pages);
  print_longest(pages);
  const std::vector<TrustQuestion> questions = trust_questions(pages);
  fmt::print("\n{}\n", words_of(questions));
  std::fflush(stdout);
  const auto count = [&](auto is) {
    return std::count_if(results.begin(), results.end(), [&](const ProblemResult& result) { return is(result.end.kind); });
  };
  const auto unfinished = count([](jobs::JobEnd::Kind kind) { return outcome_of(kind) == jobs::Outcome::unfinished; });
  const bool queued = count([](jobs::JobEnd::Kind kind) { return kind == jobs::JobEnd::Kind::queued; }) > 0;
  if (unfinished > 0)
    io::tell("{}: {} of {} problems are done; the same command {}\n", queued ? "queued" : "interrupted",
             static_cast<std::ptrdiff_t>(results.size()) - unfinished, results.size(),
             queued ? "collects the others" : "continues from there");
  write_book(request.output, pages, questions);
  io::tell("the book is {}\n", (request.output / "index.html").string());
  if (request.quote) quote_results(pages);
  if (unfinished > 0) return jobs::Outcome::unfinished;
  return all_met(pages) ? jobs::Outcome::done : jobs::Outcome::failed;
}

}  // namespace berm::verification
