// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "report/results/curve_figures.hpp"

#include "plot/figure.hpp"
#include "structures/pipe/plots.hpp"
#include "structures/pipe/travel_curve.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* from_zero = "set key below\nset yrange [0:*]\n";
constexpr int width = 1000, height = 660;  // pixels

/// What a figure shows over what: columns of the path of a push or a drag.
struct Chart {
  const char *name, *title, *x_label, *y_label;
  std::vector<Real> pipe::PipePath::*x;
  std::vector<Real> (*y)(const pipe::PipePath&);
  plot::PlotUnit (*unit)(Real max);  ///< of y
};

plot::PlotUnit no_unit(Real)
{
  return {1, "1"};
}

std::vector<Real> H_over_V(const pipe::PipePath& path)
{
  std::vector<Real> ratio;
  for (std::size_t k = 0; k < path.drag_H.size(); ++k) ratio.push_back(path.drag_H[k] / path.drag_V[k]);
  return ratio;
}

const Chart charts[] = {
    {"V_w", "Vertical resistance in the push", "embedment w", "vertical resistance V", &pipe::PipePath::w,
     [](const pipe::PipePath& p) { return p.V; }, plot::force_unit},
    {"H_u", "Horizontal resistance in the drag", "horizontal displacement u", "horizontal resistance H", &pipe::PipePath::drag_u,
     [](const pipe::PipePath& p) { return p.drag_H; }, plot::force_unit},
    {"w_u", "Embedment in the drag", "horizontal displacement u", "embedment w", &pipe::PipePath::drag_u,
     [](const pipe::PipePath& p) { return p.drag_w; }, plot::length_unit},
    {"H_over_V_u", "Ratio of forces in the drag", "horizontal displacement u", "H/V", &pipe::PipePath::drag_u, H_over_V, no_unit}};

std::string label_with(const std::string& words, const plot::PlotUnit& unit)
{
  return std::string(unit.name) == "1" ? words : fmt::format("{} ({})", words, unit.name);
}

std::vector<Real> scaled(std::vector<Real> values, Real factor)
{
  for (Real& value : values) value *= factor;
  return values;
}

Real largest(const std::vector<Real>& values)
{
  Real max = 0;
  for (const Real value : values)
    if (std::isfinite(value)) max = std::max(max, std::abs(value));
  return max;
}

bool draw_both(const fs::path& folder, const std::string& name, const plot::Figure& figure)
{
  return draw_figure(folder, name, figure, plot::PlotFormat::png) && draw_figure(folder, name, figure, plot::PlotFormat::svg);
}

/// The rows of a run, pale, and the same freed from noise.
void add_run(plot::Figure& figure, const Chart& chart, const pipe::RunRecord& run, std::size_t number, const plot::PlotUnit& x_unit,
             const plot::PlotUnit& y_unit)
{
  const pipe::PipePath path = pipe_path(run.history, run.stages);
  const std::vector<Real>&x = path.*chart.x, y = chart.y(path);
  const pipe::TravelCurve curve(x, y);
  if (curve.empty()) return;
  const pipe::TravelCurve smooth = curve.smoothed(averaging_half(run.scale));
  if (run.scale.noisy) figure.curves.push_back({"", plot::curve_style(number, 0, 0.4), scaled(x, x_unit.per_si), scaled(y, y_unit.per_si)});
  figure.curves.push_back(
      {run.name, plot::curve_style(number, number), scaled(smooth.travel(), x_unit.per_si), scaled(smooth.value(), y_unit.per_si)});
}

/// A figure of all runs over one another, with what is published; false where no run has the curve.
bool draw_chart(const std::vector<pipe::RunRecord>& runs, const std::vector<PublishedPoint>& published, const Chart& chart,
                const fs::path& folder)
{
  const auto has_path = [](const pipe::RunRecord& run) { return run.has_pipe() && run.history.rows() > 0; };
  Real max = 0, longest = 0;
  for (const pipe::RunRecord& run : runs) {
    if (!has_path(run)) continue;
    const pipe::PipePath path = pipe_path(run.history, run.stages);
    max = std::max(max, largest(chart.y(path)));
    longest = std::max(longest, largest(path.*chart.x));
  }
  if (max == 0) return false;
  const plot::PlotUnit x_unit = plot::length_unit(longest), y_unit = chart.unit(max);
  plot::Figure figure{chart.title, label_with(chart.x_label, x_unit), label_with(chart.y_label, y_unit), {}, from_zero, width, height};
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (has_path(runs[k])) add_run(figure, chart, runs[k], k, x_unit, y_unit);
  for (const PublishedPoint& point : published) {
    if (std::string(word_of(point.chart)) != chart.name) continue;
    const std::vector<Real> x = point.x ? std::vector<Real>{*point.x} : std::vector<Real>{0, longest};
    figure.curves.push_back({point.label, point.x ? "points pt 7 ps 1.4 lc rgb '#000000'" : "lines dt 3 lw 1.5 lc rgb '#000000'",
                             scaled(x, x_unit.per_si), std::vector<Real>(x.size(), point.y * y_unit.per_si)});
  }
  return draw_both(folder, chart.name, figure);
}

/// Columns of a run's history over time, those that it has.
struct TimeChart {
  const char *name, *title, *y_words, *y_unit;               ///< y_unit: nullptr for that of the columns
  std::vector<std::pair<const char*, const char*>> columns;  ///< of the history, by their labels, and their words
  Real per_si;
  const char* more;
};
const TimeChart time_charts[] = {
    {"energies",
     "Energies",
     "energy since the start",
     nullptr,
     {{"kinetic", "kinetic"},
      {"internal", "internal"},
      {"damping", "damping"},
      {"friction", "friction"},
      {"external", "external work"},
      {"energy error", "error"}},
     1,
     "set key below\n"},
    {"contact", "Contact", "distance", "mm", {{"gap", "gap"}, {"overlap", "deepest overlap"}}, 1000, from_zero}};

bool draw_time_chart(const pipe::RunRecord& run, const TimeChart& chart, const fs::path& folder)
{
  if (run.history.rows() < 2) return false;
  plot::Figure figure{fmt::format("{}: {}", run.name, chart.title), "time (s)", "", {}, chart.more, width, height};
  for (const auto& [column, words] : chart.columns) {
    const std::size_t number = figure.curves.size();
    if (!run.history.has_label(column) || !(largest(run.history.by_label(column)) > 0)) continue;
    const std::string unit = chart.y_unit != nullptr ? chart.y_unit : run.history.column_by_label(column).unit;
    figure.y_label = fmt::format("{} ({})", chart.y_words, unit);
    figure.curves.push_back(
        {words, plot::curve_style(number, number), run.history["time_s"], scaled(run.history.by_label(column), chart.per_si)});
  }
  return !figure.curves.empty() && draw_both(folder, fmt::format("{}_{}", pipe::file_name_of(run.name), chart.name), figure);
}

}  // namespace

std::vector<std::string> draw_curves(const std::vector<pipe::RunRecord>& runs, const std::vector<PublishedPoint>& published,
                                     const fs::path& folder)
{
  std::vector<std::string> names;
  for (const Chart& chart : charts)
    if (draw_chart(runs, published, chart, folder)) names.emplace_back(chart.name);
  for (const pipe::RunRecord& run : runs)
    for (const TimeChart& chart : time_charts)
      if (draw_time_chart(run, chart, folder)) names.push_back(fmt::format("{}_{}", pipe::file_name_of(run.name), chart.name));
  return names;
}

}  // namespace berm::report
