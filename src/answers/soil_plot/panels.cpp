// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_plot/panels_columns_test.cpp
#include "soil_plot/panels.hpp"

#include "io/atomic_file.hpp"
#include "os/text_of_list.hpp"
#include "plot/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::soil_plot {

std::string margins(const PanelPlace& place)
{
  return fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n", place.left,
                     place.right, place.bottom, place.top);
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
  std::string data = fmt::format("# time_s {}\n", text_of_list(columns, " "));
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
  return plot::draw(folder.path(), "curves", panels_width, panels_height, script + "unset multiplot\n");
}

}  // namespace berm::soil_plot
