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

using By = LoadCurve::By;

/// Rows of the history in stages that load the line.
std::vector<std::size_t> loaded_rows(const record::RunRecord& run)
{
  std::vector<std::size_t> rows;
  const std::vector<StageEnd> ends = stage_ends(run);
  for (std::size_t k = 0; k < run.history.stage.size(); ++k)
    if (std::ranges::any_of(ends, [&](const StageEnd& end) { return end.name == run.history.stage[k]; })) rows.push_back(k);
  return rows;
}

/// What the curves are over.
struct LoadAxis {
  const char *column, *title;
  Real scale;
};
constexpr LoadAxis load_axes[] = {
    {"line_T_K", "rise of temperature (K)", 1}, {"line_p_Pa", "rise of pressure (MPa)", 1e-6}, {"time_s", "time (s)", 1}};

std::vector<Real> picked(const std::vector<Real>& values, const std::vector<std::size_t>& rows, Real scale)
{
  std::vector<Real> some;
  for (const std::size_t row : rows) some.push_back(scale * values[row]);
  return some;
}

const LoadAxis& axis_of(const run_folder::History& history, const std::vector<std::size_t>& rows)
{
  const auto changes = [&](const LoadAxis& axis) { return plot::largest_size(picked(history[axis.column], rows, 1)) > 0; };
  return *std::find_if(std::begin(load_axes), std::end(load_axes) - 1, changes);
}

/// One panel: columns of the history, and what Hobbs has for it.
struct PanelOf {
  const char *name, *title;
  Real scale;
  std::vector<std::pair<By, const char*>> columns;
  Real formulas::HobbsBuckle::*hobbs;
};
const PanelOf panels_of_line[] = {
    {"P",
     "compression P (kN)",
     1e-3,
     {{By::constrained, "line_P0_N"}, {By::line, "line_P_N"}, {By::springs, "springs_P_N"}},
     &formulas::HobbsBuckle::compression},
    {"y", "lateral displacement y (m)", 1, {{By::line, "line_y_m"}, {By::springs, "springs_y_m"}}, &formulas::HobbsBuckle::amplitude},
    {"M", "bending moment M (kN m)", 1e-3, {{By::line, "line_M_Nm"}, {By::springs, "springs_M_Nm"}}, &formulas::HobbsBuckle::moment}};

std::string name_by(By by, const problem::Case& c)
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
std::vector<std::size_t> first_rise(const std::vector<Real>& P0, const std::vector<std::size_t>& rows)
{
  std::vector<std::size_t> rise;
  Real largest = 0;
  for (const std::size_t row : rows)
    if (P0[row] > largest) rise.push_back(row), largest = P0[row];
  constexpr std::size_t most = 200;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < rise.size(); k += rise.size() / most + 1) some.push_back(rise[k]);
  if (!rise.empty() && some.back() != rise.back()) some.push_back(rise.back());
  return some;
}

std::string style_of(By by, std::size_t color)
{
  switch (by) {
  case By::line:
    return plot::curve_style(color, 0);
  case By::constrained:
    return "lines lw 1.2 lc rgb '#999999' dt '.'";
  case By::springs:
    return plot::curve_style(color + 2, 1);
  case By::hobbs:
    return plot::curve_style(color + 4, 3);
  }
  return "";
}

}  // namespace

LoadCurves load_curves(const record::RunRecord& run)
{
  LoadCurves curves;
  const std::vector<std::size_t> rows = loaded_rows(run);
  if (rows.size() < 2) return curves;
  const run_folder::History& history = run.history;
  const LoadAxis& axis = axis_of(history, rows);
  curves.x_title = axis.title;
  const std::vector<std::size_t> rise = first_rise(history["line_P0_N"], rows);
  const HobbsLine hobbs(run.settings, run.settings.pipeline->far_soil.friction);
  std::vector<formulas::HobbsBuckle> buckles;
  for (const std::size_t row : rise) buckles.push_back(hobbs.at(history["line_P0_N"][row]));
  for (const PanelOf& of : panels_of_line) {
    LoadPanel panel{of.name, of.title, {}};
    for (const auto& [by, column] : of.columns)
      if (history.has(column))
        panel.curves.push_back(
            {by, name_by(by, run.settings), picked(history[axis.column], rows, axis.scale), picked(history[column], rows, of.scale)});
    LoadCurve theory{By::hobbs, name_by(By::hobbs, run.settings), {}, {}};
    for (std::size_t k = 0; k < rise.size(); ++k)
      if (const Real value = buckles[k].*of.hobbs; !std::isnan(value)) {
        theory.x.push_back(axis.scale * history[axis.column][rise[k]]);
        theory.y.push_back(of.scale * value);
      }
    if (!theory.x.empty()) panel.curves.push_back(std::move(theory));
    curves.panels.push_back(std::move(panel));
  }
  return curves;
}

bool draw_load_curves(const run_folder::RunFolder& folder, const record::RunRecord& run)
{
  const LoadCurves curves = load_curves(run);
  if (curves.panels.empty()) return false;
  folder.subfolder("plots");
  std::string data;
  std::string script = soil_plot::begin_panels(run.settings.title) +
                       fmt::format("set format '%g'\nset yrange [*<0:*]\nset xlabel {}\n", plot::gnuplot_text(curves.x_title)) +
                       "set key at screen 0.57,0.40 left top Left reverse vertical maxcols 1\n";  // of P, which has all
  constexpr std::array<soil_plot::PanelPlace, 3> places{{{0.08, 0.48, 0.56, 0.89}, {0.57, 0.97, 0.56, 0.89}, {0.08, 0.48, 0.09, 0.42}}};
  int block = 0;
  for (std::size_t p = 0; p < curves.panels.size(); ++p) {
    const LoadPanel& panel = curves.panels[p];
    script += soil_plot::margins(places[p]) + fmt::format("set ylabel {}\nplot ", plot::gnuplot_text(panel.title));
    for (const LoadCurve& curve : panel.curves) {
      data += fmt::format("{}# {}, {}\n", block > 0 ? "\n\n" : "", panel.title, curve.name);
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        data += std::isfinite(curve.y[k]) ? fmt::format("{:.8g} {:.8g}\n", curve.x[k], curve.y[k]) : "\n";
      script += fmt::format("{}'curves.dat' index {} using 1:2 with {} title {}", &curve == &panel.curves.front() ? "" : ", \\\n     ",
                            block++, style_of(curve.by, 0), plot::gnuplot_text(curve.name));
    }
    script += "\nunset label 1\nunset key\n";
  }
  io::write_atomically(folder.file("plots/curves.dat"), data);
  return plot::draw(folder.path(), "curves", soil_plot::panels_width, soil_plot::panels_height, script + "unset multiplot\n");
}

std::vector<std::string> draw_load_figures(const base::Runs& runs, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  std::vector<LoadCurves> all;
  for (const base::PageRun& run : runs) all.push_back(load_curves(*run.record));
  for (const PanelOf& of : panels_of_line) {
    plot::Figure figure{of.title, "", of.title, {}, "set yrange [*<0:*]\n", 1000, 660};
    for (std::size_t k = 0; k < runs.size(); ++k)
      for (const LoadPanel& panel : all[k].panels) {
        if (panel.name != of.name) continue;
        figure.x_label = all[k].x_title;
        for (const LoadCurve& curve : panel.curves)
          figure.curves.push_back({runs.size() > 1 ? fmt::format("{}, {}", runs[k].record->name, curve.name) : curve.name,
                                   style_of(curve.by, runs[k].number), curve.x, curve.y});
      }
    const std::string name = fmt::format("pipeline_{}", of.name);
    if (!figure.curves.empty() && draw_png_and_svg(folder, name, figure)) drawn.push_back(name);
  }
  return drawn;
}

}  // namespace berm::line
