// SPDX-License-Identifier: BSD-3-Clause
#include "run/finding.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

std::string number_text(Real value)
{
  return fmt::format("{:.5g}", value);
}

std::string percent(Real part)
{
  return fmt::format("{:.3g} %", 100 * part);
}

std::string exact_of(const Expectation& e)
{
  const std::string unit = unit_of(e);
  if (e.exact) return value_text(*e.exact, unit);
  if (e.least && e.most) return number_text(*e.least) + " .. " + value_text(*e.most, unit);
  return e.least ? ">= " + value_text(*e.least, unit) : "<= " + value_text(*e.most, unit);
}

const ProblemResult& result_of(const std::string& run, const Example& example, const std::vector<ProblemResult>& results)
{
  const auto named = [&](const auto& entry) { return entry.first == run; };
  return results.at(std::find_if(example.runs.begin(), example.runs.end(), named) - example.runs.begin());
}

/// Takes the values of the runs; false, and the verdict and reason say why, where one has none.
bool take_values(Finding& finding, const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  for (const std::string& run : runs_of(e)) {
    const ProblemResult& result = result_of(run, example, results);
    if (result.end.kind == JobEnd::Kind::interrupted) return false;
    finding.verdict = Verdict::failed;
    finding.reason = e.runs.empty() ? result.end.reason : fmt::format("{}: {}", run, result.end.reason);
    if (result.end.kind == JobEnd::Kind::failed) return false;
    try {
      finding.values.push_back(evaluate(e.reading, result.folder));
    } catch (const std::exception& error) {
      finding.reason = error.what();
      return false;
    }
  }
  return true;
}

}  // namespace

const char* word_of(Verdict verdict)
{
  constexpr const char* words[] = {"met", "MISSED", "FAILED", "not run"};
  return words[static_cast<int>(verdict)];
}

std::string value_text(Real value, const std::string& unit)
{
  return number_text(value) + (unit.empty() ? "" : " " + unit);
}

Finding find_out(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  Finding finding;
  finding.problem = fmt::format("{}/{}", example.name, e.runs.empty() ? e.run : e.runs.front() + " .. " + e.runs.back());
  finding.what = words_of(e);
  finding.exact = exact_of(e);
  finding.tolerance = e.tolerance ? percent(*e.tolerance) : e.absolute_tolerance ? value_text(*e.absolute_tolerance, unit_of(e)) : "";
  if (!take_values(finding, example, e, results)) {
    finding.values.clear();
    return finding;
  }
  finding.number = number_of(e, finding.values);
  finding.reason.clear();
  finding.berm = value_text(finding.number, unit_of(e));
  const Real error = error_of(e, finding.number);
  finding.error = e.tolerance ? percent(error) : number_text(error);
  finding.verdict = is_met(e, finding.number) ? Verdict::met : Verdict::missed;
  return finding;
}

}  // namespace berm
