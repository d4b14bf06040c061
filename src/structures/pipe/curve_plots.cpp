// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/plots_test.cpp
#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "structures/pipe/plots.hpp"
#include "structures/pipe/travel_curve.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

constexpr int width = 1200, height = 900;

// Where a panel lies on the canvas, in parts of it.
struct Place {
  Real left, right, bottom, top;
};

std::string margins(const Place& p)
{
  return fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n", p.left,
                     p.right, p.bottom, p.top);
}

std::string begin_panels(const std::string& title)
{
  return fmt::format("set multiplot\n"
                     "set label 1 {} at screen 0.5,0.965 center font 'DejaVu Sans,17'\n"
                     "set grid lc rgb '#dddddd' lt 1\nset border lc rgb '#444444'\nset tics nomirror textcolor rgb '#222222'\nset key "
                     "samplen 2 spacing 1.2\n"
                     "push = '#1764ab'\ndrag = '#c8452f'\n",
                     plot::gnuplot_text(title));
}

/// Columns of the file: travel, value of the row, value freed from noise, and a partner taken along (freed from noise).
std::string block(const std::vector<Real>& travel, const std::vector<std::vector<Real>>& values, Real half, Real travel_unit,
                  const std::vector<Real>& units)
{
  std::vector<TravelCurve> curves;
  for (const auto& value : values) curves.emplace_back(travel, value);
  std::string text;
  for (std::size_t k = 0; k < travel.size(); ++k) {
    text += fmt::format("{:.6g}", travel[k] * travel_unit);
    for (std::size_t c = 0; c < values.size(); ++c) {
      const Real smooth = curves[c].at(travel[k], half);
      for (const Real value : {values[c][k], smooth}) text += std::isnan(value) ? " NaN" : fmt::format(" {:.6g}", value * units[c]);
    }
    text += '\n';
  }
  return text;
}

/// 1, 2 or 5 times a power of ten, so that about five steps make the range.
Real tic_step(Real range)
{
  const Real rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  return power * (rough < 1.5 * power ? 1 : rough < 3.5 * power ? 2 : rough < 7.5 * power ? 5 : 10);
}

/// One axis of a panel from 0, or from the least number where that is negative, to the most; in the plot's unit.
struct Axis {
  char letter;  ///< x or y
  std::string label;
  bool downwards;
  Real min = 0, max = 0;
  Real second = 0;  ///< the axis on the other side is this one times this; 0 = there is none
  std::string second_label;

  void take(const std::vector<Real>& values, Real per_si)
  {
    for (const Real value : values)
      if (!std::isnan(value)) min = std::min(min, value * per_si), max = std::max(max, value * per_si);
  }

  std::string script() const
  {
    const Real margin = max > min ? 0.04 * (max - min) : 1, from = min < 0 ? min - margin : 0, to = max + margin;
    const auto range = [&](Real factor) {
      return fmt::format("[{:.6g}:{:.6g}]", factor * (downwards ? to : from), factor * (downwards ? from : to));
    };
    std::string words = fmt::format("set {0}label {1}\nset {0}range {2}\nset {0}tics {3:.6g}\n", letter, plot::gnuplot_text(label),
                                    range(1), tic_step(to - from));
    if (second > 0)
      words += fmt::format("set {0}2label {1}\nset {0}2range {2}\nset {0}2tics {3:.6g}\n", letter, plot::gnuplot_text(second_label),
                           range(second), tic_step(second * (to - from)));
    return words;
  }
};

constexpr const char* next_panel = "unset label 1\nunset x2tics\nunset x2label\nunset y2tics\nunset y2label\n";

}  // namespace

bool draw_pipe_curves(const run_folder::RunFolder& folder, const run_folder::History& history, const PipeScale& scale,
                      const PipeStages& stages, const std::string& title)
{
  PipePath path = pipe_path(history, stages);
  // The way down to the surface is of no interest, and its V = 0 would smooth away the first touch.
  std::size_t kept = 0;
  for (std::size_t k = 0; k < path.w.size(); ++k)
    if (path.w[k] >= 0) path.w[kept] = path.w[k], path.V[kept++] = path.V[k];
  path.w.resize(kept);
  path.V.resize(kept);
  const bool has_push = path.w.size() > 1, has_drag = path.drag_u.size() > 1;
  if (!has_push && !has_drag) return false;
  const Real D = scale.diameter, half = averaging_half(scale), unit_force = scale.unit_weight * D * D;
  Real max = 0;
  for (const auto* list : {&path.V, &path.drag_V, &path.drag_H})
    for (const Real force : *list) max = std::isnan(force) ? max : std::max(max, std::abs(force));
  const plot::PlotUnit length = plot::length_unit(D), force = plot::force_unit(max);

  folder.subfolder("plots");
  const std::string units = fmt::format("({}, {})", length.name, force.name);
  std::string data = fmt::format("# push {}: w, V, V freed from noise\n", units);
  data += has_push ? block(path.w, {path.V}, half, length.per_si, {force.per_si}) : "NaN NaN NaN\n";
  data += fmt::format("\n\n# drag {}: u, H, H freed from noise, w, w freed from noise, V, V freed from noise\n", units);
  data += has_drag ? block(path.drag_u, {path.drag_H, path.drag_w, path.drag_V}, half, length.per_si,
                           {force.per_si, length.per_si, force.per_si})
                   : "NaN NaN NaN NaN NaN NaN NaN\n";
  io::write_atomically(folder.file("plots/curves.dat"), data);

  const Real per_force = unit_force > 0 ? 1 / (unit_force * force.per_si) : 0, per_length = 1 / (D * length.per_si);
  const auto force_axis = [&](char axis, const std::string& words, const char* symbol) {
    return Axis{.letter = axis,
                .label = fmt::format("{} {} ({})", words, symbol, force.name),
                .downwards = false,
                .second = per_force,
                .second_label = fmt::format("{}/(γ'D²)", symbol)};
  };
  const auto length_axis = [&](char axis, const std::string& words, const char* symbol, bool downwards) {
    return Axis{.letter = axis,
                .label = fmt::format("{} {} ({})", words, symbol, length.name),
                .downwards = downwards,
                .second = per_length,
                .second_label = fmt::format("{}/D", symbol)};
  };
  Axis V = force_axis('x', "vertical reaction", "V"), H = force_axis('y', "soil resistance", "H");
  Axis w = length_axis('y', "embedment", "w", true), w_drag = w, u = length_axis('x', "horizontal displacement", "u", false), u_below = u;
  V.take(path.V, force.per_si);
  w.take(path.w, length.per_si);
  H.take(path.drag_H, force.per_si);
  w_drag.take(path.drag_w, length.per_si);
  if (has_drag) V.take(path.drag_V, force.per_si), w.take(path.drag_w, length.per_si);
  for (Axis* axis : {&u, &u_below}) axis->take(path.drag_u, length.per_si);
  u_below.second = 0;

  std::string script = begin_panels(title);
  if (has_push) {
    script += margins(has_drag ? Place{0.075, 0.40, 0.085, 0.84} : Place{0.10, 0.88, 0.085, 0.84}) + V.script() + w.script();
    script += "set key bottom left opaque\n";
    script += "plot 'curves.dat' index 0 using 2:1 with lines lc rgb '#b8d0ea' lw 1 notitle, \\\n"
              "     '' index 0 using 3:1 with lines lc rgb push lw 2.5 title 'push'";
    script += has_drag ? ", \\\n     '' index 1 using 7:5 with lines lc rgb drag lw 2.5 title 'drag'\n" : "\n";
    script += next_panel;
  }
  if (has_drag) {
    const Real left = has_push ? 0.565 : 0.10, right = has_push ? 0.915 : 0.88;
    script += margins({left, right, 0.52, 0.84}) + u.script() + H.script();
    script += "plot 'curves.dat' index 1 using 1:2 with lines lc rgb '#f0c4bb' lw 1 notitle, '' index 1 using 1:3 with lines lc rgb drag "
              "lw 2.5 notitle\n";
    script += next_panel + margins({left, right, 0.085, 0.43}) + u_below.script() + w_drag.script();
    script += "plot 'curves.dat' index 1 using 1:5 with lines lc rgb drag lw 2.5 notitle\n";
  }
  return plot::draw(folder.path(), "curves", width, height, script + "unset multiplot\n");
}

bool draw_columns(const run_folder::RunFolder& folder, const run_folder::History& history, const std::vector<std::string>& columns,
                  const std::string& title)
{
  std::vector<std::pair<std::string, std::vector<std::size_t>>> panels;  // unit, columns
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string& unit = history.column(columns[k]).unit;
    auto panel = std::find_if(panels.begin(), panels.end(), [&](const auto& p) { return p.first == unit; });
    if (panel == panels.end()) panel = panels.insert(panel, {unit, {}});
    panel->second.push_back(k);
  }
  if (panels.empty() || history.rows() < 2) return false;

  folder.subfolder("plots");
  std::string data = fmt::format("# time_s {}\n", fmt::join(columns, " "));
  for (Index row = 0; row < history.rows(); ++row) {
    data += fmt::format("{:.8g}", history["time_s"][row]);
    for (const std::string& column : columns) {
      const Real value = history[column][row];
      data += std::isfinite(value) ? fmt::format(" {:.6g}", value) : " NaN";
    }
    data += '\n';
  }
  io::write_atomically(folder.file("plots/curves.dat"), data);

  constexpr std::array colors{"#1764ab", "#c8452f", "#2f8f4e", "#8155a6", "#c98a16", "#4a4a4a"};
  std::string script = begin_panels(title) + "set key at graph 0,1.01 left bottom horizontal Left reverse\n";
  script += fmt::format("set xrange [{:.8g}:{:.8g}]\n", history["time_s"].front(),
                        std::max(history["time_s"].back(), history["time_s"].front() + 1e-9));
  const Real rows = static_cast<Real>(panels.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Real top = 0.89 - static_cast<Real>(p) * 0.87 / rows;
    script += margins({0.10, 0.97, top - 0.87 / rows + 0.065, top});
    const auto& [unit, list] = panels[p];
    const std::string unit_label = unit == "1" ? "" : fmt::format(" ({})", unit);
    if (p + 1 == panels.size()) script += "set xlabel 'time (s)'\n";
    const bool alone = list.size() == 1;
    script += fmt::format("set ylabel {}\nplot ", plot::gnuplot_text(alone         ? history.column(columns[list[0]]).label + unit_label
                                                                     : unit == "1" ? ""
                                                                                   : unit));
    for (std::size_t k = 0; k < list.size(); ++k)
      script +=
          fmt::format("{}'curves.dat' using 1:{} with lines lw 2 lc rgb '{}' {}", k > 0 ? ", \\\n     " : "", list[k] + 2,
                      colors[k % colors.size()], alone ? "notitle" : "title " + plot::gnuplot_text(history.column(columns[list[k]]).label));
    script += "\nunset label 1\n";
  }
  return plot::draw(folder.path(), "curves", width, height, script + "unset multiplot\n");
}

}  // namespace berm::pipe
