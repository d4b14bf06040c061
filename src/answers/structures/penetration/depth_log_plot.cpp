// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/depth_log_test.cpp
#include "structures/penetration/depth_log.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/panels.hpp"

#include <fmt/format.h>

namespace berm::penetration {
namespace {

std::string data_of(const plot::PanelCurve& curve)
{
  std::string data;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    data += std::isfinite(curve.x[k]) ? fmt::format("{:.7g} {:.7g}\n", curve.x[k], curve.y[k]) : "\n";
  return data;
}

}  // namespace

std::string script_of(const plot::Panels& log, const std::filesystem::path& folder, const std::string& name)
{
  if (log.panels.empty()) return "";
  io::make_inner_folder(folder, "plots");
  std::string script = soil_plot::begin_panels(log.title);
  script += fmt::format("set yrange [{:.6g}:{:.6g}]\nset format '%g'\nset key bottom left reverse Left opaque\n", log.panels.front().high,
                        log.panels.front().low);
  const Real count = static_cast<Real>(log.panels.size()), wide = (0.86 - 0.05 * (count - 1)) / count;
  int file = 0;
  for (std::size_t p = 0; p < log.panels.size(); ++p) {
    const plot::Panel& panel = log.panels[p];
    const Real from = 0.08 + static_cast<Real>(p) * (wide + 0.05);
    const bool last = p + 1 == log.panels.size();
    script += soil_plot::margins({from, from + wide, 0.04, 0.85});
    script +=
        fmt::format("unset xtics\nset x2range [0:{0:.6g}]\nset xrange [0:{0:.6g}]\nset x2tics\nset grid x2tics ytics\nset x2label {1}\n",
                    panel.right, plot::gnuplot_text(panel.title));
    script += p == 0 ? fmt::format("set ylabel {}\n", plot::gnuplot_text(log.y_label)) : "unset ylabel\nset format y ''\n";
    if (last && log.second > 0)
      script += fmt::format("set y2range [{:.6g}:{:.6g}]\nset y2tics\nset format y2 '%g'\nset y2label 'z/D'\n",
                            log.panels.front().high / log.second, log.panels.front().low / log.second);
    std::string plots;
    for (const plot::PanelCurve& curve : panel.curves) {
      const std::string data = fmt::format("{}_{}.dat", name, file++);
      io::write_atomically(folder / "plots" / data, data_of(curve));
      plots += fmt::format("{}{} using 1:2 with {} {}", plots.empty() ? "plot " : ", \\\n     ", plot::gnuplot_text("./" + data),
                           curve.style.gnuplot, curve.name.empty() ? "notitle" : "title " + plot::gnuplot_text(curve.name));
    }
    script += plots + "\nunset label 1\n";
  }
  return script + "unset multiplot\n";
}

}  // namespace berm::penetration
