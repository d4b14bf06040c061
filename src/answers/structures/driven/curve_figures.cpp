// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "structures/driven/report.hpp"

#include "plot/figure.hpp"
#include "record/travel_curve.hpp"
#include "structures/driven/run_charts.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

namespace fs = std::filesystem;
using record::TravelCurve;

constexpr int width = 1000, height = 660;  // pixels

/// What a figure shows of run_charts.
struct Chart {
  const char *name, *title, *x_label, *y_label;
  plot::PlotUnit (*unit)(Real max, int dimension);  ///< of y
};

plot::PlotUnit no_unit(Real, int)
{
  return {1, "1"};
}
plot::PlotUnit length_unit(Real max, int)
{
  return plot::length_unit(max);
}

const Chart charts[] = {
    {"V_w", "Vertical resistance in the push", "embedment w", "vertical resistance V", plot::force_unit},
    {"H_u", "Horizontal resistance in the drag", "horizontal displacement u", "horizontal resistance H", plot::force_unit},
    {"w_u", "Embedment in the drag", "horizontal displacement u", "embedment w", length_unit},
    {"H_over_V_u", "Ratio of forces in the drag", "horizontal displacement u", "H/V", no_unit}};

std::string label_with(const std::string& words, const plot::PlotUnit& unit)
{
  return std::string(unit.name) == "1" ? words : fmt::format("{} ({})", words, unit.name);
}

/// The rows of a run, pale, and the same freed from noise where that means something.
void add_run(plot::Figure& figure, const std::vector<base::Curve>& lines, const DrivenRun& run, const plot::PlotUnit& x_unit,
             const plot::PlotUnit& y_unit)
{
  for (const base::Curve& line : lines) {
    const bool has_mean = std::ranges::any_of(line.smooth, [](Real y) { return std::isfinite(y); });
    const auto add = [&](const std::string& name, const std::string& style, const std::vector<Real>& y) {
      figure.curves.push_back({name, style, plot::scaled(line.x, x_unit.per_si), plot::scaled(y, y_unit.per_si)});
    };
    const std::string name = &line == &lines.front() ? run.name : "";
    if (run.scale.noisy) add(has_mean ? "" : name, plot::curve_style(run.number, 0, 0.4), line.y);
    if (has_mean) add(name, plot::curve_style(run.number, run.number), line.smooth);
  }
}

/// A figure of all runs over one another, with what is published; false where no run has the curve.
/// With the unit, or those of the plane and of space where the runs are of both.
std::string y_label(const Chart& chart, Real max, const DrivenRuns& runs)
{
  const auto is_of = [&](int dimension) {
    return std::any_of(runs.begin(), runs.end(), [&](const DrivenRun& run) { return run.scale.dimension == dimension; });
  };
  const plot::PlotUnit plane = chart.unit(max, 2), space = chart.unit(max, 3);
  if (!is_of(2) || !is_of(3) || std::string(plane.name) == space.name) return label_with(chart.y_label, is_of(2) ? plane : space);
  return fmt::format("{} ({}, whole body {})", chart.y_label, plane.name, space.name);
}

bool draw_chart(const DrivenRuns& runs, const std::vector<base::Charts>& of_runs, const base::PublishedPoints& published,
                const Chart& chart, const fs::path& folder)
{
  std::vector<std::vector<base::Curve>> lines;
  Real max = 0, longest = 0;
  for (const base::Charts& of_run : of_runs) {
    lines.push_back(curves_in(of_run, chart.name));
    std::erase_if(lines.back(), [](const base::Curve& line) { return TravelCurve(line.x, line.y).empty(); });
    for (const base::Curve& line : lines.back()) {
      max = std::max(max, plot::largest_size(line.y));
      longest = std::max(longest, plot::largest_size(line.x));
    }
  }
  if (max == 0) return false;
  const plot::PlotUnit x_unit = plot::length_unit(longest), y_unit = chart.unit(max, runs.front().scale.dimension);
  plot::Figure figure{chart.title, label_with(chart.x_label, x_unit), y_label(chart, max, runs), {}, plot::from_zero, width, height};
  for (std::size_t k = 0; k < runs.size(); ++k) add_run(figure, lines[k], runs[k], x_unit, y_unit);
  for (const base::PublishedPoint& point : published) {
    if (std::string(word_of(point.chart)) != chart.name) continue;
    const std::vector<Real> x = point.x ? std::vector<Real>{*point.x} : std::vector<Real>{0, longest};
    figure.curves.push_back({point.label, point.x ? "points pt 7 ps 1.4 lc rgb '#000000'" : "lines dt 3 lw 1.5 lc rgb '#000000'",
                             plot::scaled(x, x_unit.per_si), std::vector<Real>(x.size(), point.y * y_unit.per_si)});
  }
  return draw_png_and_svg(folder, chart.name, figure);
}

}  // namespace

std::vector<std::string> draw_travel_figures(const DrivenRuns& runs, const base::PublishedPoints& published, const fs::path& folder)
{
  std::vector<base::Charts> of_runs;
  for (const DrivenRun& run : runs) of_runs.push_back(run_charts(run.history, run.scale, run.stages));
  std::vector<std::string> names;
  for (const Chart& chart : charts)
    if (draw_chart(runs, of_runs, published, chart, folder)) names.emplace_back(chart.name);
  return names;
}

}  // namespace berm::driven
