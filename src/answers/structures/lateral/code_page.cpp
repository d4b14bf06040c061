// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/codes_test.cpp
#include "structures/lateral/code_page.hpp"

#include "plot/panels.hpp"
#include "structures/lateral/axial_codes.hpp"
#include "structures/lateral/codes.hpp"
#include "structures/lateral/p_y.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr std::size_t max_panels = 4;
constexpr int code_points = 60;  // of a curve

plot::CurveStyle code_style(std::size_t number)
{
  return {fmt::format("stroke:{};stroke-width:1.4;stroke-dasharray:{}", plot::curve_color(number + 1), number % 2 == 0 ? "7 3" : "3 3")};
}

/// A depth: p over y, both positive where the soil resists, with the codes.
plot::Panel panel_of(const PyCurve& curve, const std::vector<CodeMethod>& codes, bool with_key)
{
  const Real side = curve.y.back() < 0 ? -1 : 1,
             most = std::abs(*std::ranges::max_element(curve.y, {}, [](Real y) { return std::abs(y); }));
  plot::Panel panel{fmt::format("{} below the seabed", text::length_words(curve.z)), 0, 1e3 * most};
  const auto named = [&](const std::string& name) { return with_key ? name : std::string(); };
  std::vector<Real> y, p;
  for (std::size_t k = 0; k < curve.y.size(); ++k) y.push_back(1e3 * side * curve.y[k]), p.push_back(side * curve.p[k] / 1e3);
  panel.curves.push_back({named("berm"), plot::thick_style(0), y, p});
  for (std::size_t n = 0; n < codes.size(); ++n) {
    y.clear(), p.clear();
    for (int k = 0; k <= code_points; ++k) {
      const Real part = Real(k) / code_points, at = most * part * part;  // dense where it is steep
      y.push_back(1e3 * at), p.push_back(codes[n].p(curve.z, at).value / 1e3);
    }
    panel.curves.push_back({named(codes[n].name), code_style(n), y, p});
  }
  for (const plot::PanelCurve& drawn : panel.curves)
    for (const Real value : drawn.y)
      if (std::isfinite(value)) panel.high = std::max(panel.high, value), panel.low = std::min(panel.low, value);
  return panel;
}

std::string load_table(const LateralRun& run, const std::vector<CodeMethod>& codes, const std::string& id)
{
  const LateralResults& r = run.results();
  text::HtmlTable table(id, fmt::format("{}: H of a rigid pile by design codes and published methods", run.record.name));
  table.columns({{"method"},
                 {fmt::format("H at u = {} of the load, kN", text::length_words(r.u_load)), true},
                 {"berm/method", true},
                 {"pivot below the seabed, m", true},
                 {"largest H, kN", true},
                 {"source"},
                 {"choices"},
                 {"kind"},
                 {"range of validity"}});
  const auto number = [](Real value) { return text::HtmlCell{text::table_number(value), true}; };
  table.row({{"berm"}, number(r.H / 1e3), {""}, number(r.pivot), {""}, {"this run"}, {""}, {""}, {""}});
  for (const CodeMethod& code : codes) {
    const RigidPile there = rigid_pile(code, run.path.length, r.height, r.u_load);
    const RigidPile most = rigid_pile(code, run.path.length, r.height, infinity);
    const formulas::Source source = code.p(run.path.length / 2, r.u).source;
    table.row({{text::html_text(code.name)},
               number(there.H / 1e3),
               number(r.H / there.H),
               number(there.pivot),
               number(most.H / 1e3),
               {text::html_text(citation(source))},
               {text::html_text(code.choices)},
               {word_of(source.label)},
               {(there.valid ? "" : "out of range: ") + text::html_text(source.range)}},
              there.valid ? "" : "out_of_range");
  }
  return table.html();
}

}  // namespace

std::string code_curves(const LateralRun& run)
{
  const std::vector<PyCurve> curves = py_curves(run);
  if (curves.empty()) return "";
  const std::vector<CodeMethod> codes = code_methods(run);
  plot::Panels all{.title = fmt::format("{}: p-y curves by depth, with those of design codes", run.record.name),
                   .css_class = "depth_log",
                   .x_label = "y, mm",
                   .y_label = "p, kN/m",
                   .width = 230,
                   .height = 230};
  const std::size_t count = std::min(max_panels, curves.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t n = count == 1 ? 0 : k * (curves.size() - 1) / (count - 1);
    all.panels.push_back(panel_of(curves[n], codes, k == 0));
  }
  return plot::svg_of(all);
}

std::string code_values(const LateralRuns& runs, const std::string& id)
{
  std::string html;
  for (const LateralRun& run : runs) {
    if (run.empty() || run.H_curve().empty()) continue;
    const std::vector<CodeMethod> codes = code_methods(run);
    if (codes.empty()) continue;
    html +=
        load_table(run, codes, fmt::format("{}-codes-{}", id, run.number)) + axial_table(run, fmt::format("{}-axial-{}", id, run.number));
  }
  if (html.empty()) return "";
  return "<h3>Design codes and published methods</h3>\n" + html +
         text::html_paragraph("Each method's p(y) holds a rigid pile whose point of load is displaced as in the run: the tilt is that at "
                              "which the moment of the soil "
                              "about that point vanishes. PISA adds moments along the shaft and reactions of the base. berm's H includes "
                              "the shear and the pressure "
                              "on the base and the friction of the sides. Kind fit: as public programs have it; the printed texts were not "
                              "seen (docs/formulas.md).",
                              "quiet");
}

}  // namespace berm::lateral
