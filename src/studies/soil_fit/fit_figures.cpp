// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_report_test.cpp
#include "plot/figure.hpp"
#include "soil_fit/fit_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <tuple>

namespace berm::soil_fit {
namespace {

constexpr Real kilo = 1e-3, percent = 100;

/// A value of a curve as it is shown; resistances over that of the first passage.
Real shown(const MeasuredTest& test, const MeasuredCurve& curve, Real value)
{
  if (test.passages) return value / curve.values.front();
  return is_strain(curve.what) ? percent * engineering_strain(value) : kilo * value;
}

Real shown_along(const MeasuredTest& test, Real driven)
{
  return as_measured(test, driven) * (test.passages ? 1 : test.by_stress() ? kilo : percent);
}

/// Which tests share a figure: "triaxial_drained", "t_bar".
std::string kind_of(const MeasuredTest& test)
{
  if (test.passages) return test.passages->tool;
  return fmt::format("{}_{}", element::kind_word(test.settings.kind), element::drained(test.settings.kind) ? "drained" : "undrained");
}

plot::Figure figure_of(const std::vector<const FittedTest*>& tests, Compared what)
{
  plot::Figure figure;
  const MeasuredTest& first = tests.front()->measured;
  std::string kind = first.passages ? first.passages->tool : element::kind_word(first.settings.kind);
  std::replace(kind.begin(), kind.end(), '_', ' ');
  figure.title = fmt::format("{}: {}, measured (points) and computed (lines)", kind, name_of(what));
  figure.x_label = first.passages      ? "passage (1: first penetration, 2: first extraction)"
                   : first.by_stress() ? "stress (kPa)"
                   : std::holds_alternative<element::SimpleShear>(first.settings.kind) ? "shear strain (%)"
                                                                                       : "axial strain (%)";
  figure.y_label = first.passages ? "q_k / q_1" : fmt::format("{} ({})", name_of(what), is_strain(what) ? "%" : "kPa");
  std::size_t color = 0;
  for (const FittedTest* test : tests) {
    const MeasuredTest& measured = test->measured;
    const auto curve = std::find_if(measured.curves.begin(), measured.curves.end(), [&](const MeasuredCurve& c) { return c.what == what; });
    const std::vector<Real>& computed = test->computed[static_cast<std::size_t>(curve - measured.curves.begin())];
    const std::size_t c = color % plot::curve_colors, dash = color / plot::curve_colors % plot::curve_dashes;
    plot::FigureCurve points{"", fmt::format("points pt 6 ps 0.6 lc rgb '{}'", plot::curve_color(c)), {}, {}};
    plot::FigureCurve line{measured.held_out ? measured.name + " (held out)" : measured.name, plot::curve_style(c, dash, 1.5), {}, {}};
    for (std::size_t row = 0; row < measured.rows(); ++row) {
      points.x.push_back(shown_along(measured, measured.driven[row])), line.x.push_back(points.x.back());
      points.y.push_back(shown(measured, *curve, curve->values[row])), line.y.push_back(shown(measured, *curve, computed[row]));
    }
    figure.curves.push_back(points);
    figure.curves.push_back(line);
    ++color;
  }
  figure.more = "set key outside right font ',10'\n";
  if (first.by_stress()) figure.more += "set logscale x\nset yrange [*:*] reverse\n";
  figure.width = 900;
  figure.height = 520;
  return figure;
}

}  // namespace

std::vector<std::string> draw_figures(const FitResults& results, const std::filesystem::path& folder)
{
  std::map<std::tuple<std::size_t, std::string, Compared>, std::vector<const FittedTest*>> figures;
  for (const FittedTest& test : results.soil.tests)
    for (const MeasuredCurve& curve : test.measured.curves)
      figures[{test.measured.settings.kind.index(), kind_of(test.measured), curve.what}].push_back(&test);
  std::vector<std::string> drawn;
  for (const auto& [key, tests] : figures) {
    const auto& [place, kind, what] = key;
    const std::string name = fmt::format("{}_{}", kind, word_of(what));
    if (plot::draw_figure(folder, name, figure_of(tests, what))) drawn.push_back(name);
  }
  return drawn;
}

}  // namespace berm::soil_fit
