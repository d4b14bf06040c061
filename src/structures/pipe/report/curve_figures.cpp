// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "structures/pipe/report/curve_figures.hpp"

#include "plot/figure.hpp"
#include "record/travel_curve.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

namespace fs = std::filesystem;
using record::TravelCurve;

constexpr int width = 1000, height = 660;  // pixels

/// What a figure shows over what: columns of the path of a push or a drag.
struct Chart {
  const char *name, *title, *x_label, *y_label;
  std::vector<Real> PipePath::*x;
  std::vector<Real> (*y)(const PipePath&);
  plot::PlotUnit (*unit)(Real max);  ///< of y
};

plot::PlotUnit no_unit(Real)
{
  return {1, "1"};
}

std::vector<Real> H_over_V(const PipePath& path)
{
  std::vector<Real> ratio;
  for (std::size_t k = 0; k < path.drag_H.size(); ++k) ratio.push_back(path.drag_H[k] / path.drag_V[k]);
  return ratio;
}

const Chart charts[] = {
    {"V_w", "Vertical resistance in the push", "embedment w", "vertical resistance V", &PipePath::w, [](const PipePath& p) { return p.V; },
     plot::force_unit},
    {"H_u", "Horizontal resistance in the drag", "horizontal displacement u", "horizontal resistance H", &PipePath::drag_u,
     [](const PipePath& p) { return p.drag_H; }, plot::force_unit},
    {"w_u", "Embedment in the drag", "horizontal displacement u", "embedment w", &PipePath::drag_u,
     [](const PipePath& p) { return p.drag_w; }, plot::length_unit},
    {"H_over_V_u", "Ratio of forces in the drag", "horizontal displacement u", "H/V", &PipePath::drag_u, H_over_V, no_unit}};

std::string label_with(const std::string& words, const plot::PlotUnit& unit)
{
  return std::string(unit.name) == "1" ? words : fmt::format("{} ({})", words, unit.name);
}

/// The rows of a run, pale, and the same freed from noise.
void add_run(plot::Figure& figure, const Chart& chart, const PipeRun& run, const plot::PlotUnit& x_unit, const plot::PlotUnit& y_unit)
{
  const PipePath path = pipe_path(run.history, run.stages);
  const std::vector<Real>&x = path.*chart.x, y = chart.y(path);
  const TravelCurve curve(x, y);
  if (curve.empty()) return;
  const TravelCurve smooth = curve.smoothed(averaging_half(run.scale));
  if (run.scale.noisy)
    figure.curves.push_back({"", plot::curve_style(run.place, 0, 0.4), plot::scaled(x, x_unit.per_si), plot::scaled(y, y_unit.per_si)});
  figure.curves.push_back({run.name, plot::curve_style(run.place, run.place), plot::scaled(smooth.travel(), x_unit.per_si),
                           plot::scaled(smooth.value(), y_unit.per_si)});
}

/// A figure of all runs over one another, with what is published; false where no run has the curve.
bool draw_chart(const PipeRuns& runs, const base::PublishedPoints& published, const Chart& chart, const fs::path& folder)
{
  const auto has_path = [](const PipeRun& run) { return run.history.rows() > 0; };
  Real max = 0, longest = 0;
  for (const PipeRun& run : runs) {
    if (!has_path(run)) continue;
    const PipePath path = pipe_path(run.history, run.stages);
    max = std::max(max, plot::largest_size(chart.y(path)));
    longest = std::max(longest, plot::largest_size(path.*chart.x));
  }
  if (max == 0) return false;
  const plot::PlotUnit x_unit = plot::length_unit(longest), y_unit = chart.unit(max);
  plot::Figure figure{chart.title, label_with(chart.x_label, x_unit), label_with(chart.y_label, y_unit), {}, plot::from_zero, width,
                      height};
  for (const PipeRun& run : runs)
    if (has_path(run)) add_run(figure, chart, run, x_unit, y_unit);
  for (const base::PublishedPoint& point : published) {
    if (std::string(word_of(point.chart)) != chart.name) continue;
    const std::vector<Real> x = point.x ? std::vector<Real>{*point.x} : std::vector<Real>{0, longest};
    figure.curves.push_back({point.label, point.x ? "points pt 7 ps 1.4 lc rgb '#000000'" : "lines dt 3 lw 1.5 lc rgb '#000000'",
                             plot::scaled(x, x_unit.per_si), std::vector<Real>(x.size(), point.y * y_unit.per_si)});
  }
  return draw_png_and_svg(folder, chart.name, figure);
}

}  // namespace

std::vector<std::string> draw_curves(const PipeRuns& runs, const base::PublishedPoints& published, const fs::path& folder)
{
  std::vector<std::string> names;
  for (const Chart& chart : charts)
    if (draw_chart(runs, published, chart, folder)) names.emplace_back(chart.name);
  return names;
}

}  // namespace berm::pipe
