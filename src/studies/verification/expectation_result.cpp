// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/expectation_result.hpp"

#include "run_folder/summary_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

const ProblemResult& result_of(const std::string& run, const Example& example, const std::vector<ProblemResult>& results)
{
  const auto named = [&](const auto& entry) { return entry.first == run; };
  return results.at(std::find_if(example.runs.begin(), example.runs.end(), named) - example.runs.begin());
}

/// Of the runs that came to an end; where one did not, only what is expected.
ExpectationResult compare(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  const auto folder = [&](const std::string& run) { return result_of(run, example, results).folder; };
  const std::vector<std::string> runs = runs_of(e);
  for (const std::string& run : runs) {
    const jobs::JobEnd& end = result_of(run, example, results).end;
    if (outcome_of(end.kind) == jobs::Outcome::unfinished) return without_numbers(e, Verdict::not_run, "");
    if (end.kind == jobs::JobEnd::Kind::failed)
      return without_numbers(e, Verdict::failed, runs.size() == 1 ? end.reason : fmt::format("{}: {}", run, end.reason));
  }
  return compare_with_numbers(
      e, {[&](const std::string& run, const expectations::Observable& observable) { return evaluate(observable, folder(run)); },
          [&](const std::string& run, const std::string& quantity) {
            return expectations::band_of(quantity, run_folder::read_summary(folder(run)));
          }});
}

}  // namespace

ExpectationResult compare_with_expectation(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  ExpectationResult result = compare(example, e, results);
  result.problem = fmt::format("{}/{}", example.name, e.runs.empty() ? e.run : e.runs.front() + " .. " + e.runs.back());
  return result;
}

}  // namespace berm::verification
