// SPDX-License-Identifier: BSD-3-Clause
#include "run/expectation.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

namespace berm {
namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

/// What must fit together in one expectation.
void check(Describe& d, const std::string& path, const Expectation& e)
{
  d.check(e.quantity.empty() != e.column.empty(), path, "needs either a quantity of summary.json or a column of history.csv, and not both");
  d.check(e.column.empty() ? !e.from && !e.to : true, path + (e.from ? ".from" : ".to"), "only a column has a window in time");
  d.check(!e.from || !e.to || *e.from < *e.to, path + ".to", "must be later than from");
  const bool bounded = e.least || e.most;
  d.check(e.exact.has_value() != bounded, path, "needs either exact, or least and most or one of them");
  d.check(!e.least || !e.most || *e.least <= *e.most, path + ".most", "must not be less than least");
  const int tolerances = e.tolerance.has_value() + e.absolute_tolerance.has_value();
  d.check(tolerances == (bounded ? 0 : 1), path, "exact needs a tolerance or an absolute_tolerance, and bounds need none");
  d.check(!e.tolerance || e.exact != 0., path + ".tolerance", "zero needs an absolute_tolerance");
}

/// The rows of a column within the window.
struct Rows {
  std::vector<Real> time, value;
};

Rows rows_of(const Expectation& e, const History& history)
{
  if (!history.has(e.column))
    throw InputError(
        fmt::format("the history of {} has no column \"{}\"; it has {}", e.case_file, e.column, fmt::join(history.columns, ", ")));
  const std::vector<Real>&time = history["time_s"], &value = history[e.column];
  // The slack is for the round-off in the sum of time steps.
  const Real slack = time.empty() ? 0 : 1e-9 * time.back();
  Rows rows;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (e.from && time[k] < *e.from - slack) continue;
    if (e.to && time[k] > *e.to + slack) continue;
    rows.time.push_back(time[k]);
    rows.value.push_back(value[k]);
  }
  return rows;
}

/// The coefficient of t^degree in the least-squares polynomial of that degree through the rows: that of the last of the polynomials
/// p_k = t p_(k-1) less its parts along the earlier ones, which are orthogonal over the rows.
Real highest_coefficient(const Rows& rows, int degree)
{
  const std::size_t count = rows.time.size();
  if (count <= static_cast<std::size_t>(degree)) return unknown;
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
  if (n < 3) return unknown;
  return (crossings[n - 1] + crossings[n - 2] - crossings[1] - crossings[0]) / static_cast<Real>(n - 2);
}

}  // namespace

void describe(Describe& d, Expectation& e)
{
  d.value("case", e.case_file, {.meaning = "case file in the example's folder"});
  d.value("set", e.set, {.meaning = "parameters changed for this run, each KEY=VALUE as for --set"});
  d.value("quantity", e.quantity, {.meaning = "quantity of summary.json"});
  d.value("column", e.column, {.meaning = "column of history.csv, instead of a quantity"});
  d.choice("measure", e.measure, measure_words, {.meaning = "number that is taken from the column"});
  d.value("from", e.from, {.meaning = "begin of the window in time; absent = first row", .unit = "s"});
  d.value("to", e.to, {.meaning = "end of the window in time; absent = last row", .unit = "s"});
  const std::string unit = unit_of(e);
  d.value("exact", e.exact, {.meaning = "value to expect", .unit = unit.c_str()});
  d.value("tolerance", e.tolerance, {.meaning = "largest |value / exact - 1|", .range = positive});
  d.value("absolute_tolerance", e.absolute_tolerance, {.meaning = "largest |value - exact|", .unit = unit.c_str(), .range = positive});
  d.value("least", e.least, {.meaning = "least value to expect, instead of exact", .unit = unit.c_str()});
  d.value("most", e.most, {.meaning = "largest value to expect, instead of exact", .unit = unit.c_str()});
  d.value("source", e.source, {.meaning = "where the expected value comes from", .required = true});
  d.value("why", e.why, {.meaning = "why the tolerance or the bounds are what they are", .required = true});
}

void describe(Describe& d, Expectations& all)
{
  d.array("expect", all.expect, {.meaning = "numbers to expect", .required = true});
  for (std::size_t k = 0; k < all.expect.size(); ++k) check(d, fmt::format("expect[{}]", k), all.expect[k]);
}

std::string unit_of(const std::string& name)
{
  const auto starts = [&](const char* text) { return name.starts_with(text); };
  if (name.find("_over_") != std::string::npos || starts("V_rms_error")) return "";
  if (name.ends_with("_m_s")) return "m/s";
  if (name.ends_with("_J_m")) return "J/m";
  if (name.ends_with("_N_m") || starts("V_") || starts("H_") || starts("second_impulse")) return "N/m";
  if (name.ends_with("_m") || starts("w_") || starts("u_") || starts("overlap") || starts("gap")) return "m";
  return "";
}

std::string unit_of(const Expectation& e)
{
  if (e.column.empty()) return unit_of(e.quantity);
  const std::string unit = unit_of(e.column);
  if (e.measure == Measure::period) return "s";
  if (e.measure == Measure::acceleration) return "m/s^2";
  if (e.measure == Measure::slope) return fmt::format("{}/s", unit.empty() ? "1" : unit);
  return unit;
}

Real evaluate(const Expectation& e, const History& history)
{
  const Rows rows = rows_of(e, history);
  if (rows.value.empty()) return unknown;
  switch (e.measure) {
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
    return e.column.ends_with("_m_s") ? highest_coefficient(rows, 1) : 2 * highest_coefficient(rows, 2);
  case Measure::period:
    return period_of(rows);
  }
  return unknown;
}

Real evaluate(const Expectation& e, const std::filesystem::path& summary)
{
  std::ifstream file(summary);
  const nlohmann::json quantities = nlohmann::json::parse(file).at("quantities");
  std::vector<std::string> names;
  for (const auto& [name, quantity] : quantities.items()) {
    names.push_back(name);
    if (name == e.quantity) return quantity.at("value").is_number() ? quantity.at("value").get<Real>() : unknown;
  }
  throw InputError(fmt::format("{} has no quantity \"{}\"; it has {}", summary.string(), e.quantity, fmt::join(names, ", ")));
}

Real error_of(const Expectation& e, Real value)
{
  if (e.exact) return e.tolerance ? (value - *e.exact) / std::abs(*e.exact) : value - *e.exact;
  if (e.least && value < *e.least) return value - *e.least;
  if (e.most && value > *e.most) return value - *e.most;
  return std::isnan(value) ? value : 0;
}

bool is_met(const Expectation& e, Real value)
{
  return std::abs(error_of(e, value)) <= (e.exact ? e.tolerance ? *e.tolerance : *e.absolute_tolerance : 0);
}

}  // namespace berm
