// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/load_curves_test.cpp
#include "plot/figure.hpp"
#include "structures/line/load_curves.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::line {
namespace {

constexpr Real wide = 300, high = 230, left_of_chart = 64, right_of_chart = 14, above_chart = 30, below_chart = 52,
               key_height = 18;  // pixels, of a panel

const char* svg_style_of(LoadCurve::By by)
{
  switch (by) {
  case LoadCurve::By::line:
    return "stroke:var(--link);stroke-width:2";
  case LoadCurve::By::constrained:
    return "stroke:var(--quiet);stroke-width:1;stroke-dasharray:2 3";
  case LoadCurve::By::springs:
    return "stroke:#2f8f4e;stroke-width:1.6;stroke-dasharray:7 4";
  case LoadCurve::By::hobbs:
    return "stroke:var(--published);stroke-width:1.6;stroke-dasharray:9 3 2 3";
  }
  return "";
}

/// From numbers to pixels along one axis.
struct ChartAxis {
  Real least = 0, most = 0, origin, pixels;

  void take(const std::vector<Real>& values)
  {
    for (const Real value : values)
      if (std::isfinite(value)) least = std::min(least, value), most = std::max(most, value);
  }
  Real operator()(Real value) const { return origin + pixels * (value - least) / (most - least); }
  std::vector<Real> tics() const
  {
    const Real step = plot::tic_step(most - least);
    std::vector<Real> at;
    for (Real k = std::ceil(least / step); k * step <= most; ++k) at.push_back(k * step + 0.);
    return at;
  }
};

std::string chart_text(Real x, Real y, const char* anchor, const std::string& words, const std::string& more = "")
{
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more, text::html_text(words));
}

std::string chart_line(Real x1, Real y1, Real x2, Real y2, const char* style)
{
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" style=\"{}\"/>\n", x1, y1, x2, y2, style);
}

std::string panel_svg(const LoadPanel& panel, const std::string& x_title, Real left)
{
  ChartAxis x{.origin = left, .pixels = wide}, y{.origin = above_chart + high, .pixels = -high};
  for (const LoadCurve& curve : panel.curves) x.take(curve.x), y.take(curve.y);
  if (!(x.most > x.least && y.most > y.least)) return "";
  std::string svg = chart_text(left + wide / 2, above_chart - 12, "middle", panel.title, " font-weight=\"600\"") +
                    chart_text(left + wide / 2, above_chart + high + 38, "middle", x_title);
  constexpr const char* grid = "stroke:var(--grid);stroke-width:1";
  for (const Real at : x.tics())
    svg += chart_line(x(at), above_chart, x(at), above_chart + high, grid) +
           chart_text(x(at), above_chart + high + 18, "middle", text::short_number(at));
  for (const Real at : y.tics())
    svg += chart_line(left, y(at), left + wide, y(at), grid) + chart_text(left - 7, y(at) + 4, "end", text::short_number(at));
  for (const LoadCurve& curve : panel.curves) {
    constexpr std::size_t most_points = 600;
    const std::size_t stride = curve.x.size() / most_points + 1;
    std::string points;
    for (std::size_t k = 0; k < curve.x.size(); k += stride)
      if (std::isfinite(curve.y[k])) points += fmt::format("{:.1f},{:.1f} ", x(curve.x[k]), y(curve.y[k]));
    svg += fmt::format("<polyline points=\"{}\" style=\"fill:none;{}\"/>\n", points, svg_style_of(curve.by));
  }
  return svg;
}

}  // namespace

std::string load_chart(const record::RunRecord& run)
{
  const LoadCurves curves = load_curves(run);
  if (curves.panels.empty()) return "";
  constexpr Real panel_room = left_of_chart + wide + right_of_chart;
  std::string panels, key;
  Real width = 0;
  for (const LoadPanel& panel : curves.panels) panels += panel_svg(panel, curves.x_title, width + left_of_chart), width += panel_room;
  Real level = above_chart + high + below_chart;
  for (const LoadCurve& curve : curves.panels.front().curves) {  // P has all
    key += chart_line(left_of_chart, level, left_of_chart + 34, level, svg_style_of(curve.by)) +
           chart_text(left_of_chart + 42, level + 4, "start", curve.name);
    level += key_height;
  }
  return fmt::format("<figure class=\"load_chart\"><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
                     "style=\"max-width:100%;height:auto;font:13px sans-serif;fill:var(--text)\" role=\"img\">\n"
                     "<title>{2}: compression, lateral displacement and moment over the load</title>\n{3}{4}</svg></figure>\n",
                     width, level, text::html_text(run.name), panels, key);
}

}  // namespace berm::line
