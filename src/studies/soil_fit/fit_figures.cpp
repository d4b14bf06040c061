// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_report_test.cpp
#include "plot/figure.hpp"
#include "soil_fit/fit_report.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_fit {
namespace {

constexpr Real kilo = 1e-3, percent = 100;

Real shown(Compared what, Real value)
{
  return is_strain(what) ? percent * engineering_strain(value) : kilo * value;
}

Real shown_along(const MeasuredTest& test, Real driven)
{
  return as_measured(test, driven) * (test.by_stress() ? kilo : percent);
}

plot::Figure figure_of(const std::vector<const FittedTest*>& tests, Compared what)
{
  plot::Figure figure;
  const MeasuredTest& first = tests.front()->measured;
  std::string kind = element::kind_word(first.settings.kind);
  std::replace(kind.begin(), kind.end(), '_', ' ');
  figure.title = fmt::format("{}: {}, measured (points) and computed (lines)", kind, name_of(what));
  figure.x_label = first.by_stress()                                                   ? "stress (kPa)"
                   : std::holds_alternative<element::SimpleShear>(first.settings.kind) ? "shear strain (%)"
                                                                                       : "axial strain (%)";
  figure.y_label = fmt::format("{} ({})", name_of(what), is_strain(what) ? "%" : "kPa");
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
      points.y.push_back(shown(what, curve->values[row])), line.y.push_back(shown(what, computed[row]));
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
  std::vector<std::string> drawn;
  for (std::size_t kind = 0; kind < std::variant_size_v<element::TestKind>; ++kind)
    for (const bool drained : {true, false})
      for (const Compared what :
           {Compared::q, Compared::tau, Compared::p, Compared::vertical_stress, Compared::volumetric_strain, Compared::axial_strain}) {
        std::vector<const FittedTest*> tests;
        for (const FittedTest& test : results.soil.tests) {
          const auto& curves = test.measured.curves;
          if (test.measured.settings.kind.index() == kind && element::drained(test.measured.settings.kind) == drained &&
              std::any_of(curves.begin(), curves.end(), [&](const MeasuredCurve& c) { return c.what == what; }))
            tests.push_back(&test);
        }
        if (tests.empty()) continue;
        const std::string name = fmt::format("{}_{}_{}", element::kind_word(tests.front()->measured.settings.kind),
                                             drained ? "drained" : "undrained", word_of(what));
        if (plot::draw_figure(folder, name, figure_of(tests, what))) drawn.push_back(name);
      }
  return drawn;
}

}  // namespace berm::soil_fit
