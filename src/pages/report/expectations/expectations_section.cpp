// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/expectations/expectations_section_test.cpp
#include "report/expectations/expectations_section.hpp"

#include "report/expectations/expected_runs.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using expectations::Expectation;
using expectations::ExpectationResult;
using expectations::Expectations;
using expectations::Verdict;

std::string badge_of(Verdict verdict)
{
  const text::Standing standing = verdict == Verdict::met ? text::Standing::good : text::Standing::bad;
  return html_badge(standing, verdict == Verdict::met ? "met" : verdict == Verdict::missed ? "missed" : "failed");
}

void add_row(text::HtmlTable& table, const std::string& run, const Expectation& e, const ExpectationResult& result)
{
  const std::string tolerance = result.tolerance.empty() ? "" : fmt::format(" (tolerance {})", result.tolerance);
  const std::string why = result.reason.empty() ? fmt::format("{}; {}", e.source, e.why) : result.reason;
  table.row({{text::html_text(run)},
             {text::html_text(result.what)},
             {text::html_text(result.exact + tolerance)},
             {text::html_text(result.berm)},
             {badge_of(result.verdict)},
             {fmt::format("{} <span class=\"quiet\">{}</span>", text::html_text(e.requirement), text::html_text(why))}});
}

}  // namespace

bool is_of_a_test(const record::RunRecord& run, const ExpectationSheets& sheets)
{
  return std::any_of(sheets.begin(), sheets.end(),
                     [&](const Expectations& sheet) { return sheet.published && !name_of(run, sheet).empty(); });
}

base::PublishedPoints published_points(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets)
{
  base::PublishedPoints points;
  for (const Expectations& sheet : sheets)
    if (std::any_of(runs.begin(), runs.end(), [&](const record::RunRecord& run) { return is_of_a_test(run, {sheet}); }))
      points.insert(points.end(), sheet.published->points.begin(), sheet.published->points.end());
  return points;
}

std::string expectations_section(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets)
{
  text::HtmlTable table("expected-table", "Expected values of these runs, and results");
  table.columns({{"run"}, {"number"}, {"expected"}, {"berm"}, {"verdict"}, {"basis"}});
  for (const Expectations& sheet : sheets) {
    const ExpectedRuns expected(runs, sheet);
    for (const ExpectedRun& run : expected.runs())
      for (const Expectation& e : sheet.expect)
        if (runs_of(e).front() == run.name && expected.have(e)) add_row(table, run.record->name, e, expected.compare(e, run));
  }
  if (table.empty()) return "";
  return text::html_section("expected", "Expected", table.html());
}

}  // namespace berm::report
