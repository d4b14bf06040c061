// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/load_curves_test.cpp
#include "structures/line/load_curves.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "soil_plot/panels.hpp"
#include "structures/line/answers.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::line {
namespace {

/// Whose curve it is.
enum class By { line, constrained, springs, hobbs };

/// Rows of the history in stages that load the line.
std::vector<Index> loaded_rows(const record::RunRecord& run)
{
  std::vector<Index> rows;
  const std::vector<StageEnd> ends = stage_ends(run);
  for (Index k = 0; k < run.history.rows(); ++k)
    if (std::ranges::any_of(ends, [&](const StageEnd& end) { return end.name == run.history.stage[k]; })) rows.push_back(k);
  return rows;
}

/// What the curves are over.
struct LoadAxis {
  const char *column, *title;
  Real scale;  ///< from SI
  base::Chart::Axis axis;
};
const LoadAxis load_axes[] = {{"line_T_K", "rise of temperature (K)", 1, {"rise of temperature", "T", "K"}},
                              {"line_p_Pa", "rise of pressure (MPa)", 1e-6, {"rise of pressure", "p", "Pa"}},
                              {"time_s", "time (s)", 1, {"time", "t", "s"}}};

std::vector<Real> picked(const std::vector<Real>& values, const std::vector<Index>& rows)
{
  std::vector<Real> some;
  for (const Index row : rows) some.push_back(values[row]);
  return some;
}

const LoadAxis& axis_of(const run_folder::History& history, const std::vector<Index>& rows)
{
  const auto changes = [&](const LoadAxis& axis) { return plot::largest_size(picked(history[axis.column], rows)) > 0; };
  return *std::find_if(std::begin(load_axes), std::end(load_axes) - 1, changes);
}

/// One panel: columns of the history, and what Hobbs has for it.
struct PanelOf {
  const char *name, *title;
  Real scale;  ///< from SI
  base::Chart::Axis axis;
  std::vector<std::pair<By, const char*>> columns;
  Real formulas::HobbsBuckle::*hobbs;
};
const PanelOf panels_of_line[] = {{"P",
                                   "compression P (kN)",
                                   1e-3,
                                   {"effective compression", "P", "N"},
                                   {{By::constrained, "line_P0_N"}, {By::line, "line_P_N"}, {By::springs, "springs_P_N"}},
                                   &formulas::HobbsBuckle::compression},
                                  {"y",
                                   "lateral displacement y (m)",
                                   1,
                                   {"lateral displacement", "y", "m"},
                                   {{By::line, "line_y_m"}, {By::springs, "springs_y_m"}},
                                   &formulas::HobbsBuckle::amplitude},
                                  {"M",
                                   "bending moment M (kN m)",
                                   1e-3,
                                   {"bending moment", "M", "N m"},
                                   {{By::line, "line_M_Nm"}, {By::springs, "springs_M_Nm"}},
                                   &formulas::HobbsBuckle::moment}};

std::string name_by(By by, const settings::Case& c)
{
  switch (by) {
  case By::line:
    return "line on slices";
  case By::constrained:
    return "P₀, far from the buckle";
  case By::springs:
    return "line on springs";
  case By::hobbs:
    return fmt::format("Hobbs, far_soil {:.3g} W", c.pipeline->far_soil.friction);
  }
  return "";
}

/// The rows in which the constrained force is larger than ever before, 200 at most.
std::vector<Index> first_rise(const std::vector<Real>& P0, const std::vector<Index>& rows)
{
  std::vector<Index> rise;
  Real largest = 0;
  for (const Index row : rows)
    if (P0[row] > largest) rise.push_back(row), largest = P0[row];
  constexpr std::size_t most = 200;
  std::vector<Index> some;
  for (std::size_t k = 0; k < rise.size(); k += rise.size() / most + 1) some.push_back(rise[k]);
  if (!rise.empty() && some.back() != rise.back()) some.push_back(rise.back());
  return some;
}

std::string style_of(const std::string& name, const settings::Case& c, std::size_t color)
{
  if (name == name_by(By::line, c)) return plot::curve_style(color, 0);
  if (name == name_by(By::springs, c)) return plot::curve_style(color + 2, 1);
  return name == name_by(By::hobbs, c) ? plot::curve_style(color + 4, 3) : "lines lw 1.2 lc rgb '#999999' dt '.'";
}

/// The axis of the load of charts, with its title and unit.
const LoadAxis& load_axis(const base::Chart& chart)
{
  return *std::ranges::find_if(load_axes, [&](const LoadAxis& load) { return load.axis.words == chart.x.words; });
}

}  // namespace

base::Charts load_charts(const record::RunRecord& run)
{
  base::Charts charts;
  const std::vector<Index> rows = loaded_rows(run);
  if (rows.size() < 2) return charts;
  const run_folder::History& history = run.history;
  const LoadAxis& load = axis_of(history, rows);
  const std::vector<Index> rise = first_rise(history["line_P0_N"], rows);
  const HobbsLine hobbs(run.settings, run.settings.pipeline->far_soil.friction);
  std::vector<formulas::HobbsBuckle> buckles;
  for (const Index row : rise) buckles.push_back(hobbs.at(history["line_P0_N"][row]));
  for (const PanelOf& of : panels_of_line) {
    base::Chart chart{fmt::format("{}_load", of.name), load.axis, of.axis};
    chart.title = fmt::format("Line: {}({})", of.axis.symbol, load.axis.symbol);
    for (const auto& [by, column] : of.columns)
      if (history.has(column))
        chart.curves.push_back({name_by(by, run.settings), rows, picked(history[load.column], rows), picked(history[column], rows)});
    base::Curve theory{name_by(By::hobbs, run.settings)};
    for (std::size_t k = 0; k < rise.size(); ++k)
      if (const Real value = buckles[k].*of.hobbs; !std::isnan(value))
        theory.rows.push_back(rise[k]), theory.x.push_back(history[load.column][rise[k]]), theory.y.push_back(value);
    if (!theory.x.empty()) chart.curves.push_back(std::move(theory));
    charts.push_back(std::move(chart));
  }
  return charts;
}

bool draw_load_curves(const run_folder::RunFolder& folder, const record::RunRecord& run)
{
  const base::Charts charts = load_charts(run);
  if (charts.empty()) return false;
  folder.subfolder("plots");
  std::string data;
  std::string script =
      soil_plot::begin_panels(run.settings.title) +
      fmt::format("set format '%g'\nset yrange [*<0:*]\nset xlabel {}\n", plot::gnuplot_text(load_axis(charts.front()).title)) +
      "set key at screen 0.57,0.40 left top Left reverse vertical maxcols 1\n";  // of P, which has all
  constexpr std::array<soil_plot::PanelPlace, 3> places{{{0.08, 0.48, 0.56, 0.89}, {0.57, 0.97, 0.56, 0.89}, {0.08, 0.48, 0.09, 0.42}}};
  int block = 0;
  for (std::size_t p = 0; p < charts.size(); ++p) {
    const PanelOf& panel = panels_of_line[p];
    const Real x_scale = load_axis(charts[p]).scale;
    script += soil_plot::margins(places[p]) + fmt::format("set ylabel {}\nplot ", plot::gnuplot_text(panel.title));
    for (const base::Curve& curve : charts[p].curves) {
      data += fmt::format("{}# {}, {}\n", block > 0 ? "\n\n" : "", panel.title, curve.name);
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        data += std::isfinite(curve.y[k]) ? fmt::format("{:.8g} {:.8g}\n", x_scale * curve.x[k], panel.scale * curve.y[k]) : "\n";
      script += fmt::format("{}'curves.dat' index {} using 1:2 with {} title {}", &curve == &charts[p].curves.front() ? "" : ", \\\n     ",
                            block++, style_of(curve.name, run.settings, 0), plot::gnuplot_text(curve.name));
    }
    script += "\nunset label 1\nunset key\n";
  }
  io::write_atomically(folder.file("plots/curves.dat"), data);
  return plot::draw(folder.path(), "curves", soil_plot::panels_width, soil_plot::panels_height, script + "unset multiplot\n");
}

std::vector<std::string> draw_load_figures(const base::Runs& runs, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  for (const PanelOf& of : panels_of_line) {
    plot::Figure figure{of.title, "", of.title, {}, "set yrange [*<0:*]\n", 1000, 660};
    for (const auto& [run, number] : runs)
      for (const base::Chart& chart : load_charts(*run)) {
        if (chart.y.symbol != of.axis.symbol) continue;
        figure.x_label = load_axis(chart).title;
        for (const base::Curve& curve : chart.curves)
          figure.curves.push_back({runs.size() > 1 ? fmt::format("{}, {}", run->name, curve.name) : curve.name,
                                   style_of(curve.name, run->settings, number), plot::scaled(curve.x, load_axis(chart).scale),
                                   plot::scaled(curve.y, of.scale)});
      }
    const std::string name = fmt::format("pipeline_{}", of.name);
    if (!figure.curves.empty() && draw_png_and_svg(folder, name, figure)) drawn.push_back(name);
  }
  return drawn;
}

}  // namespace berm::line
