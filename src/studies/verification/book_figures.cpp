// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book_figures.hpp"

#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::verification {
namespace {

using expectations::Measure;
using expectations::measure_words;
using expectations::Observable;
using expectations::Rows;

constexpr const char* of_berm = "lines lw 2 lc rgb '#1764ab'";
constexpr const char* of_exact = "lines lw 2 lc rgb '#c8452f' dt '-'";
constexpr const char* of_bound = "lines lw 1.5 lc rgb '#2f8f4e' dt '-'";

/// A level over the window.
plot::FigureCurve level(const std::string& title, const char* style, const Rows& rows, Real value)
{
  return {title, style, {rows.time.front(), rows.time.back()}, {value, value}};
}

Real mean(const std::vector<Real>& values)
{
  return std::accumulate(values.begin(), values.end(), Real(0)) / static_cast<Real>(values.size());
}

/// The line (degree 1) or parabola (degree 2) of a given slope or acceleration that fits the rows best.
plot::FigureCurve expected_motion(const Rows& rows, Real rate, int degree)
{
  const Real t0 = rows.time.front();
  const auto known_part = [&](Real t) { return degree == 1 ? rate * (t - t0) : rate / 2 * (t - t0) * (t - t0); };
  std::vector<Real> rest;
  for (std::size_t k = 0; k < rows.time.size(); ++k) rest.push_back(rows.value[k] - known_part(rows.time[k]));
  const Real mean_t = mean(rows.time), mean_rest = mean(rest);
  Real product = 0, squares = 0;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    product += (rows.time[k] - mean_t) * (rest[k] - mean_rest);
    squares += (rows.time[k] - mean_t) * (rows.time[k] - mean_t);
  }
  const Real slope = degree == 2 && squares > 0 ? product / squares : 0;
  plot::FigureCurve curve{"expected", of_exact, rows.time, {}};
  for (const Real t : rows.time) curve.y.push_back(known_part(t) + mean_rest + slope * (t - mean_t));
  return curve;
}

/// Upright lines one expected period apart, from the first time that the column crosses its mean.
plot::FigureCurve marks_of_period(const Rows& rows, Real period)
{
  constexpr Real gap = nan;
  const auto [low, high] = std::minmax_element(rows.value.begin(), rows.value.end());
  const Real middle = mean(rows.value);
  std::size_t k = 1;
  while (k < rows.value.size() && (rows.value[k - 1] < middle) == (rows.value[k] < middle)) ++k;
  plot::FigureCurve marks{"expected", of_exact, {}, {}};
  constexpr int max = 50;
  for (int n = 0; n < max && k < rows.value.size() && rows.time[k] + n * period <= rows.time.back(); ++n) {
    const Real t = rows.time[k] + n * period;
    marks.x.insert(marks.x.end(), {t, t, gap});
    marks.y.insert(marks.y.end(), {*low, *high, gap});
  }
  return marks;
}

/// What is expected of a measure that is a level of the column itself.
void add_levels(plot::Figure& figure, const Expectation& e, const Rows& rows)
{
  const Real offset = e.observable.measure == Measure::change ? rows.value.front() : 0;
  if (e.exact) {
    figure.curves.push_back(level("expected", of_exact, rows, *e.exact + offset));
    const Real tolerance = e.tolerance ? *e.tolerance * std::abs(*e.exact) : *e.absolute_tolerance;
    figure.curves.push_back(level("tolerance", of_bound, rows, *e.exact + offset - tolerance));
    figure.curves.push_back(level("", of_bound, rows, *e.exact + offset + tolerance));
  }
  if (e.min) figure.curves.push_back(level("least", of_bound, rows, *e.min + offset));
  if (e.max) figure.curves.push_back(level("most", of_bound, rows, *e.max + offset));
}

plot::Figure column_figure(const Expectation& e, const run_folder::History& history)
{
  plot::Figure figure;
  const Observable& observable = e.observable;
  const std::string &name = history.column(observable.column).label, &unit = history.column(observable.column).unit;
  figure.title = fmt::format("{}: {}", name, measure_words[static_cast<std::size_t>(observable.measure)]);
  figure.x_label = "time (s)";
  figure.y_label = unit == "1" ? name : fmt::format("{} ({})", name, unit);
  figure.curves.push_back({"berm", of_berm, history["time_s"], history[observable.column]});
  const Rows rows = rows_of(observable, history);
  if (rows.time.size() < 2) return figure;
  if (observable.from || observable.to)
    figure.more = fmt::format("set object rectangle from {:.9g}, graph 0 to {:.9g}, graph 1 behind fc rgb '#eef3f9' fs solid noborder\n",
                              rows.time.front(), rows.time.back());
  const bool rate = observable.measure == Measure::slope || observable.measure == Measure::acceleration;
  if (rate && e.exact)
    figure.curves.push_back(
        expected_motion(rows, *e.exact, observable.measure == Measure::slope || is_velocity(observable, history) ? 1 : 2));
  else if (observable.measure == Measure::period && e.exact)
    figure.curves.push_back(marks_of_period(rows, *e.exact));
  else if (!rate && observable.measure != Measure::period)
    add_levels(figure, e, rows);
  return figure;
}

plot::Figure order_figure(const Expectation& e, const ExpectationResult& finding)
{
  plot::Figure figure;
  figure.title = fmt::format("{}: order {:.3g}", finding.label, finding.number);
  figure.x_label = "size divided by the coarsest, halved each time";
  figure.y_label = fmt::format("|{} - limit|{}", finding.label, finding.unit.empty() ? "" : fmt::format(" ({})", finding.unit));
  figure.width = 800;
  figure.more = "set logscale xy\nset format y '%.0e'\n";
  std::string tics;
  plot::FigureCurve errors{"berm", "points pt 7 ps 1.4 lc rgb '#1764ab'", {}, {}};
  for (std::size_t k = 0; k < finding.values.size(); ++k) {
    errors.x.push_back(std::pow(2, -static_cast<Real>(k)));
    tics += fmt::format("{}'{}' {:.9g}", tics.empty() ? "" : ", ", k == 0 ? "1" : fmt::format("1/{}", 1LL << k), errors.x.back());
    errors.y.push_back(std::abs(finding.values[k] - *e.limit));
  }
  figure.more += fmt::format("set xrange [{:.6g}:1.25]\nset xtics ({})\n", errors.x.back() / 1.25, tics);
  // The fitted line goes through the mean of the logarithms.
  Real middle = 0;
  for (const Real error : errors.y) middle += std::log2(error) / static_cast<Real>(errors.y.size());
  const Real center = (static_cast<Real>(errors.y.size()) - 1) / 2;
  const auto line = [&](const std::string& title, const char* style, Real order) {
    plot::FigureCurve curve{title, style, errors.x, {}};
    for (std::size_t k = 0; k < errors.x.size(); ++k) curve.y.push_back(std::pow(2, middle - order * (static_cast<Real>(k) - center)));
    return curve;
  };
  figure.curves.push_back(line(fmt::format("order {:.3g}", finding.number), of_berm, finding.number));
  if (e.exact) figure.curves.push_back(line(fmt::format("expected {:g}", *e.exact), of_exact, *e.exact));
  if (e.min) figure.curves.push_back(line(fmt::format("least {:g}", *e.min), of_bound, *e.min));
  if (e.max) figure.curves.push_back(line(fmt::format("most {:g}", *e.max), of_bound, *e.max));
  figure.curves.push_back(errors);
  return figure;
}

}  // namespace

bool draw_finding(const std::filesystem::path& folder, const std::string& name, const Expectation& e, const ExpectationResult& finding,
                  const std::filesystem::path& run_folder)
{
  if (finding.values.empty()) return false;
  if (!e.runs.empty()) return !std::isnan(finding.number) && draw_figure(folder, name, order_figure(e, finding));
  if (e.observable.column.empty() || is_pure(e)) return false;
  return plot::draw_figure(folder, name, column_figure(e, run_folder::read_history(run_folder / "history.csv")));
}

}  // namespace berm::verification
