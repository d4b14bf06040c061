// SPDX-License-Identifier: BSD-3-Clause
#include "output/gnuplot.hpp"
#include "output/plots.hpp"
#include "output/travel_curve.hpp"
#include "output/whole_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm {
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
                     gnuplot_text(title));
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

/// The second axis is the first one times a factor.
std::string linked_axis(char axis, Real factor, const std::string& label)
{
  return fmt::format("set link {0}2 via {0}*{1} inverse {0}/{1}\nset {0}2tics\nset {0}2label {2}\n", axis, factor, gnuplot_text(label));
}

constexpr const char* no_linked_axes = "unset link\nunset x2tics\nunset x2label\nunset y2tics\nunset y2label\n";

} // namespace

bool draw_pipe_curves(const RunFolder& folder, const History& history, const PipeScale& scale, const PipeStages& stages,
                      const std::string& title)
{
  const PipePath path = pipe_path(history, stages);
  const bool has_push = path.w.size() > 1, has_drag = path.drag_u.size() > 1;
  if (!has_push && !has_drag) return false;
  const Real D = scale.diameter, half = averaging_half_width * D, unit_force = scale.unit_weight * D * D;
  Real most = 0;
  for (const auto* list : {&path.V, &path.drag_V, &path.drag_H})
    for (const Real force : *list) most = std::isnan(force) ? most : std::max(most, std::abs(force));
  const PlotUnit length = length_unit(D), force = force_unit(most);

  folder.subfolder("plots");
  const std::string units = fmt::format("({}, {})", length.name, force.name);
  std::string data = fmt::format("# push {}: w, V, V freed from noise\n", units);
  data += has_push ? block(path.w, {path.V}, half, length.per_si, {force.per_si}) : "NaN NaN NaN\n";
  data += fmt::format("\n\n# drag {}: u, H, H freed from noise, w, w freed from noise, V, V freed from noise\n", units);
  data += has_drag ? block(path.drag_u, {path.drag_H, path.drag_w, path.drag_V}, half, length.per_si,
                           {force.per_si, length.per_si, force.per_si})
                   : "NaN NaN NaN NaN NaN NaN NaN\n";
  write_whole(folder.file("plots/curves.dat"), data);

  const std::string force_label = fmt::format(" ({})", force.name), length_label = fmt::format(" ({})", length.name);
  const auto second_force = [&](char axis, char letter) {
    return unit_force > 0 ? linked_axis(axis, 1 / (unit_force * force.per_si), fmt::format("{}/(γ'D²)", letter)) : "";
  };
  const auto second_length = [&](char axis, char letter) {
    return linked_axis(axis, 1 / (D * length.per_si), fmt::format("{}/D", letter));
  };

  std::string script = begin_panels(title);
  if (has_push) {
    script += margins(has_drag ? Place{0.075, 0.40, 0.085, 0.85} : Place{0.10, 0.88, 0.085, 0.85});
    script += fmt::format("set xlabel 'vertical reaction V{}'\nset ylabel 'embedment w{}'\n", force_label, length_label);
    script += "set xrange [0:*]\nset yrange [*:*] reverse\nset key bottom left opaque\n";
    script += second_force('x', 'V') + second_length('y', 'w');
    script += "plot 'curves.dat' index 0 using 2:1 with lines lc rgb '#b8d0ea' lw 1 notitle, \\\n";
    if (has_drag)
      script += "     '' index 1 using 6:4 with lines lc rgb '#f0c4bb' lw 1 notitle, '' index 1 using 7:5 with lines lc rgb drag lw 2.5 "
                "title 'drag', \\\n";
    script += "     '' index 0 using 3:1 with lines lc rgb push lw 2.5 title 'push'\n";
    script += std::string("unset label 1\n") + no_linked_axes;
  }
  if (has_drag) {
    const Real left = has_push ? 0.565 : 0.10, right = has_push ? 0.915 : 0.88;
    script += margins({left, right, 0.53, 0.85});
    script += fmt::format("set xlabel 'horizontal displacement u{}'\nset ylabel 'soil resistance H{}'\n", length_label, force_label);
    script += "set xrange [0:*]\nset yrange [*:*] noreverse\nset key bottom right\n";
    script += second_length('x', 'u') + second_force('y', 'H');
    script += "plot 'curves.dat' index 1 using 1:2 with lines lc rgb '#f0c4bb' lw 1 notitle, '' index 1 using 1:3 with lines lc rgb drag "
              "lw 2.5 notitle\n";
    script += std::string("unset label 1\n") + no_linked_axes;
    script += margins({left, right, 0.085, 0.435});
    script += fmt::format("set ylabel 'embedment w{}'\nset yrange [*:*] reverse\n", length_label);
    script += second_length('y', 'w');
    script += "plot 'curves.dat' index 1 using 1:5 with lines lc rgb drag lw 2.5 notitle\n";
  }
  return draw(folder, "curves", width, height, script + "unset multiplot\n");
}

std::pair<std::string, std::string> name_and_unit(const std::string& column)
{
  constexpr std::array<std::pair<const char*, const char*>, 11> units{{{"_N_s_m", "N s/m"},
                                                                       {"_m_s2", "m/s²"},
                                                                       {"_m_s", "m/s"},
                                                                       {"_N_m", "N/m"},
                                                                       {"_J_m", "J/m"},
                                                                       {"_Pa", "Pa"},
                                                                       {"_kg", "kg"},
                                                                       {"_N", "N"},
                                                                       {"_J", "J"},
                                                                       {"_m", "m"},
                                                                       {"_s", "s"}}};
  std::string name = column, unit = "1";
  for (const auto& [ending, words] : units)
    if (column.size() > std::string_view(ending).size() && column.ends_with(ending)) {
      name = column.substr(0, column.size() - std::string_view(ending).size());
      unit = words;
      break;
    }
  std::replace(name.begin(), name.end(), '_', ' ');
  return {name, unit};
}

bool draw_columns(const RunFolder& folder, const History& history, const std::vector<std::string>& columns, const std::string& title)
{
  std::vector<std::pair<std::string, std::vector<std::size_t>>> panels; // unit, columns
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string unit = name_and_unit(columns[k]).second;
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
  write_whole(folder.file("plots/curves.dat"), data);

  constexpr std::array colors{"#1764ab", "#c8452f", "#2f8f4e", "#8155a6", "#c98a16", "#4a4a4a"};
  std::string script = begin_panels(title) + "set xlabel 'time (s)'\n";
  const Real rows = static_cast<Real>(panels.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Real top = 0.92 - static_cast<Real>(p) * 0.92 / rows;
    script += margins({0.10, 0.97, top - 0.92 / rows + 0.085, top});
    const auto& [unit, list] = panels[p];
    const std::string unit_label = unit == "1" ? "" : fmt::format(" ({})", unit);
    const bool alone = list.size() == 1;
    script += fmt::format("set ylabel {}\nplot ", gnuplot_text((alone ? name_and_unit(columns[list[0]]).first + unit_label : unit_label)));
    for (std::size_t k = 0; k < list.size(); ++k)
      script += fmt::format("{}'curves.dat' using 1:{} with lines lw 2 lc rgb '{}' {}", k > 0 ? ", \\\n     " : "", list[k] + 2,
                            colors[k % colors.size()], alone ? "notitle" : "title " + gnuplot_text(name_and_unit(columns[list[k]]).first));
    script += "\nunset label 1\n";
  }
  return draw(folder, "curves", width, height, script + "unset multiplot\n");
}

} // namespace berm
