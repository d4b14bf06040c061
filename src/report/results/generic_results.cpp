// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "report/results/generic_results.hpp"

#include "structures/pipe/display_units.hpp"
#include "text/html.hpp"
#include "text/tex_math.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

std::string quantities_table(const pipe::RunRecord& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: results", run.name));
  table.columns({{"quantity"}, {"value", true}, {"unit"}});
  for (const run_folder::Quantity& q : run.quantities)
    table.row({{text::html_text(q.name)}, {pipe::table_number(q.value), true}, {q.unit == "1" ? "" : text::html_text(q.unit)}});
  return table.empty() ? "" : table.html();
}

bool is_watched(const problem::Case& c, const run_folder::Column& column)
{
  return std::any_of(c.watch.begin(), c.watch.end(), [&](const auto& watch) { return column.of == watch.first; });
}

std::string watched_table(const pipe::RunRecord& run, const std::string& id)
{
  const run_folder::History& history = run.history;
  if (history.rows() == 0) return "";
  const std::string when = history.has("time_s") ? fmt::format(" after {} s", pipe::short_number(history["time_s"].back())) : "";
  text::HtmlTable table(id, fmt::format("{}: what it watches, at its end{}", run.name, when));
  table.columns({{"column of the history"}, {"meaning"}, {"last value", true}, {"unit"}});
  for (std::size_t c = 0; c < history.columns.size(); ++c)
    if (is_watched(run.settings, history.columns[c]))
      table.row({{text::html_text(history.columns[c].name)},
                 {text::html_text(history.columns[c].meaning)},
                 {pipe::table_number(history.values[c].back()), true},
                 {text::html_text(history.columns[c].unit)}});
  return table.empty() ? "" : table.html();
}

std::string checks_table(const pipe::RunRecord& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: checks", run.name));
  table.columns({{"check"}, {"value", true}});
  if (run.summary)
    for (const auto& [name, value] : run.summary->checks) table.row({{text::html_text(name)}, {pipe::table_number(value), true}});
  return table.empty() ? "" : table.html();
}

}  // namespace

std::string other_results(const pipe::RunRecord& run, const std::string& id)
{
  const std::string results = quantities_table(run, id + "-quantities") + watched_table(run, id + "-watched");
  return results.empty() ? checks_table(run, id + "-checks") : results;
}

}  // namespace berm::report
