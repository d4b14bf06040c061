// SPDX-License-Identifier: BSD-3-Clause
#include "expectations/observable.hpp"

#include "input/message_text.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "run_folder/summary_file.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::expectations {
namespace {

/// The coefficient of t^degree in the least-squares polynomial of that degree through the rows: that of the last of the polynomials
/// p_k = t p_(k-1) less its parts along the earlier ones, which are orthogonal over the rows.
Real highest_coefficient(const Rows& rows, int degree)
{
  const std::size_t count = rows.time.size();
  if (count <= static_cast<std::size_t>(degree)) return nan;
  const auto dot = [](const std::vector<Real>& a, const std::vector<Real>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), Real(0));
  };
  std::vector<std::vector<Real>> polynomials = {std::vector<Real>(count, 1)};
  for (int k = 1; k <= degree; ++k) {
    std::vector<Real> next = polynomials.back();
    for (std::size_t row = 0; row < count; ++row) next[row] *= rows.time[row] - rows.time[0];
    for (const std::vector<Real>& earlier : polynomials) {
      const Real part = dot(next, earlier) / dot(earlier, earlier);
      for (std::size_t row = 0; row < count; ++row) next[row] -= part * earlier[row];
    }
    polynomials.push_back(next);
  }
  return dot(rows.value, polynomials.back()) / dot(polynomials.back(), polynomials.back());
}

/// Mean distance of each crossing of the mean from the next but one: a level that is a little off moves neighbours apart, but not these.
Real period_of(const Rows& rows)
{
  const Real level = std::accumulate(rows.value.begin(), rows.value.end(), Real(0)) / static_cast<Real>(rows.value.size());
  std::vector<Real> crossings;
  for (std::size_t k = 1; k < rows.value.size(); ++k) {
    const Real before = rows.value[k - 1] - level, now = rows.value[k] - level;
    if ((before < 0) != (now < 0)) crossings.push_back(rows.time[k - 1] + (rows.time[k] - rows.time[k - 1]) * before / (before - now));
  }
  const std::size_t n = crossings.size();
  if (n < 3) return nan;
  return (crossings[n - 1] + crossings[n - 2] - crossings[1] - crossings[0]) / static_cast<Real>(n - 2);
}

Reading reading_of(const run_folder::Quantity& number)
{
  return {number.value, number.unit == "1" ? "" : number.unit, number.name};
}

/// One of these quantities, of checks and timing of a summary, or of the details; both may be null.
Reading quantity_of(const Observable& observable, std::vector<run_folder::Quantity> numbers, const run_folder::RunSummary* summary,
                    const base::RunDetails& details)
{
  if (summary != nullptr) {
    for (const auto& [name, value] : summary->checks) numbers.push_back({name, value, "1"});
    for (const auto& [name, value] : summary->timing) numbers.push_back({name, value, run_folder::unit_of_timing(name)});
  }
  std::vector<std::string> known;
  for (const run_folder::Quantity& number : numbers) {
    if (number.name == observable.quantity) return reading_of(number);
    known.push_back(number.name);
  }
  if (details.find)
    if (const auto found = details.find(observable.quantity, observable.at)) return reading_of(*found);
  known.insert(known.end(), details.names.begin(), details.names.end());
  throw InputError(one_line(fmt::format("summary.json has no quantity {}{}", input::in_quotes(observable.quantity),
                                        input::suggestion(observable.quantity, known))));
}

Reading reading_of_column(const Observable& observable, const run_folder::History& history)
{
  const Real value = evaluate(observable, history);
  return {value, unit_of(observable, history), history.column(observable.column).label};
}

}  // namespace

void describe(Describe& d, Observable& observable)
{
  d.value("quantity", observable.quantity, {.meaning = "quantity of summary.json"});
  d.value("at", observable.at, {.meaning = "where a quantity is taken that has a position: a length divided by D, a force in N/m"});
  d.value("column", observable.column, {.meaning = "column of history.csv, instead of a quantity"});
  d.choice("measure", observable.measure, measure_words, {.meaning = "number that is taken from the column"});
  d.value("from", observable.from, {.meaning = "start of the window in time; absent = first row", .unit = "s"});
  d.value("to", observable.to, {.meaning = "end of the window in time; absent = last row", .unit = "s"});
}

void check(Describe& d, const std::string& path, const Observable& r)
{
  d.check(r.quantity.empty() != r.column.empty(), path, "needs either a quantity of summary.json or a column of history.csv, and not both");
  d.check(r.column.empty() ? !r.from && !r.to : true, path + (r.from ? ".from" : ".to"), "only a column has a window in time");
  d.check(r.column.empty() || !r.at, path + ".at", "only a quantity is taken at a position");
  d.check(!r.from || !r.to || *r.from < *r.to, path + ".to", "must be later than from");
}

std::string words_of(const Observable& observable)
{
  if (observable.column.empty()) return observable.quantity + (observable.at ? fmt::format(" {:g}", *observable.at) : "");
  return fmt::format("{} {}", observable.column, measure_words[static_cast<std::size_t>(observable.measure)]);
}

std::string unit_of(const Observable& observable, const run_folder::History& history)
{
  const std::string& column = history.column(observable.column).unit;
  const std::string unit = column == run_folder::bare.name ? "" : column;
  if (observable.measure == Measure::period) return run_folder::seconds.name;
  if (observable.measure == Measure::slope) return fmt::format("{}/s", unit.empty() ? "1" : unit);
  if (observable.measure == Measure::acceleration)
    return is_velocity(observable, history) ? "m/s^2" : fmt::format("{}/s^2", unit.empty() ? "1" : unit);
  return unit;
}

bool is_velocity(const Observable& observable, const run_folder::History& history)
{
  return history.column(observable.column).unit == run_folder::metres_per_second.name;
}

Rows rows_of(const Observable& observable, const run_folder::History& history)
{
  if (!history.has(observable.column))
    throw InputError(fmt::format("the history has no column {}{}", input::in_quotes(observable.column),
                                 input::suggestion(observable.column, history.names())));
  const std::vector<Real>&time = history["time_s"], &value = history[observable.column];
  // The slack is for the round-off in the sum of time steps.
  const Real slack = time.empty() ? 0 : 1e-9 * time.back();
  Rows rows;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (observable.from && time[k] < *observable.from - slack) continue;
    if (observable.to && time[k] > *observable.to + slack) continue;
    rows.time.push_back(time[k]);
    rows.value.push_back(value[k]);
  }
  return rows;
}

Real evaluate(const Observable& observable, const run_folder::History& history)
{
  const Rows rows = rows_of(observable, history);
  if (rows.value.empty()) return nan;
  switch (observable.measure) {
  case Measure::end:
    return rows.value.back();
  case Measure::mean:
    return std::accumulate(rows.value.begin(), rows.value.end(), Real(0)) / static_cast<Real>(rows.value.size());
  case Measure::largest:
    return *std::max_element(rows.value.begin(), rows.value.end());
  case Measure::least:
    return *std::min_element(rows.value.begin(), rows.value.end());
  case Measure::change:
    return rows.value.back() - rows.value.front();
  case Measure::slope:
    return highest_coefficient(rows, 1);
  case Measure::acceleration:
    return is_velocity(observable, history) ? highest_coefficient(rows, 1) : 2 * highest_coefficient(rows, 2);
  case Measure::period:
    return period_of(rows);
  }
  return nan;
}

Reading evaluate(const Observable& observable, const std::filesystem::path& run_folder)
{
  if (!observable.column.empty()) return reading_of_column(observable, run_folder::read_history(run_folder / "history.csv"));
  const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(run_folder);
  if (!summary) throw RunError(fmt::format("there is no {}", (run_folder / "summary.json").string()));
  const bool known = std::any_of(summary->quantities.begin(), summary->quantities.end(),
                                 [&](const run_folder::Quantity& q) { return q.name == observable.quantity; });
  if (known || !record::is_run_folder(run_folder)) return quantity_of(observable, summary->quantities, &*summary, {});
  const record::RunRecord run = structures::read_run(run_folder);
  return evaluate(observable, run, structures::structure_of(run.settings).details(run));
}

Reading evaluate(const Observable& observable, const record::RunRecord& run, const base::RunDetails& details)
{
  if (!observable.column.empty()) return reading_of_column(observable, run.history);
  return quantity_of(observable, run.quantities, run.summary ? &*run.summary : nullptr, details);
}

}  // namespace berm::expectations
