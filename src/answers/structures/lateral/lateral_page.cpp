// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/lateral_page.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "soil_plot/panels.hpp"
#include "structures/lateral/code_page.hpp"
#include "structures/lateral/lateral_results.hpp"
#include "structures/lateral/p_y.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

using text::HtmlCell;

/// "4 m above the seabed".
std::string height_words(Real height)
{
  return fmt::format("{} {} the seabed", text::length_words(std::abs(height)), height < 0 ? "below" : "above");
}

std::string travel_table(const LateralRuns& runs, const std::string& id)
{
  text::HtmlTable table(id, "Lateral load H by the displacement u at the seabed");
  const bool alone = runs.size() == 1;
  std::vector<HtmlCell> columns{{"u/D"}};
  if (alone)
    for (const char* name : {"u, mm", "u at the load, mm", "tilt, °"}) columns.push_back({name, true});
  for (const LateralRun& run : runs) columns.push_back({fmt::format("H, kN, {}", text::html_text(run.record.name)), true});
  table.columns(columns);
  for (const Real part : told_at) {
    std::vector<HtmlCell> cells{{text::short_number(part)}};
    bool any = false;
    if (alone) {
      const LateralRun& run = runs.front();
      const Real u = part * run.width, tilt = run.tilt_at(u);
      for (const Real value : {u * 1e3, (u + run.results().height * std::sin(tilt)) * 1e3, tilt / degree})
        cells.push_back({text::table_number(value), true});
    }
    for (const LateralRun& run : runs) {
      const run_folder::Quantity* H = run.record.quantity(name_at(part));
      any = any || H != nullptr;
      cells.push_back({text::table_number(H == nullptr ? nan : H->value / 1e3), true});
    }
    if (any) table.row(cells);
  }
  return table.empty() ? "" : table.html();
}

std::vector<Real> at_load(const LateralRun& run)
{
  std::vector<Real> u;
  for (std::size_t k = 0; k < run.path.u.size(); ++k) u.push_back(run.path.u[k] + run.results().height * std::sin(run.path.tilt[k]));
  return u;
}

/// Units of the largest of some runs.
struct Units {
  plot::PlotUnit length{1e3, "mm"}, force{1e-3, "kN"};
};

Units units_of(const LateralRuns& runs)
{
  Real length = 0, force = 0;
  for (const LateralRun& run : runs)
    length = std::max({length, plot::largest_size(run.path.u), plot::largest_size(at_load(run))}),
    force = std::max(force, plot::largest_size(run.path.H));
  return {plot::length_unit(length), plot::force_unit(force, 3)};
}

}  // namespace

std::string lateral_words(const LateralRun& run)
{
  if (run.empty() || run.H_curve().empty()) return "";
  const LateralResults& r = run.results();
  const std::string name = text::html_text(base::body_word(run.record.settings));
  std::string words = fmt::format("Under lateral load the {} (D = {}, {} of it in the seabed) carries H = {} at a displacement of {} ({} "
                                  "D) at the seabed. The load acts {}, "
                                  "where the displacement is {}; its moment at the seabed is {} m.",
                                  name, text::length_words(run.width), text::length_words(run.path.length), text::force_words(r.H, 3),
                                  text::length_words(r.u), text::short_number(r.u / run.width), height_words(r.height),
                                  text::length_words(r.u_load), text::force_words(r.M, 3));
  if (std::isfinite(r.pivot))
    words += fmt::format(" The {} tilts by {} about a point {}.", name, text::angle_words(std::abs(r.tilt)), height_words(-r.pivot));
  if (run.strength > 0)
    words += fmt::format(" H is {} s<sub>u</sub> D L, with s<sub>u</sub> = {} on average over the length L in the seabed.",
                         text::short_number(run.over_strength(r.H)), text::stress_words(run.strength));
  return words;
}

std::string lateral_key_results(const LateralRuns& runs, const std::string& id)
{
  LateralRuns known;
  for (const LateralRun& run : runs)
    if (!run.empty() && !run.H_curve().empty()) known.push_back(run);
  if (known.empty()) return "";
  std::string html;
  for (const LateralRun& run : known) html += code_curves(run);
  html += lateral_table(known, id + "-sideways-end") + travel_table(known, id + "-sideways-u");
  for (const LateralRun& run : known) html += py_table(run, fmt::format("{}-p-y-{}", id, run.number));
  return html;
}

bool draw_lateral_curves(const run_folder::RunFolder& folder, const LateralRun& run)
{
  if (run.empty() || run.H_curve().empty()) return false;
  folder.subfolder("plots");
  const auto [length, force] = units_of({run});
  const std::vector<Real> u_load = at_load(run);
  std::string rows, mean;
  for (std::size_t k = 0; k < run.path.u.size(); ++k)
    rows += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", run.path.u[k] * length.per_si, u_load[k] * length.per_si,
                        run.path.H[k] * force.per_si, run.path.tilt[k] / degree, run.path.M[k] * force.per_si);
  const record::TravelCurve smooth = run.H_curve().drawn(run.half());
  for (std::size_t k = 0; k < smooth.travel().size(); ++k)
    mean += fmt::format("{:.6g} {:.6g}\n", smooth.travel()[k] * length.per_si, smooth.value()[k] * force.per_si);
  io::write_atomically(folder.file("plots/lateral.dat"), rows);
  io::write_atomically(folder.file("plots/lateral_mean.dat"), mean);
  std::string script =
      soil_plot::begin_panels(run.record.settings.title) + "set format '%g'\n" + soil_plot::margins({0.09, 0.48, 0.17, 0.88});
  script +=
      fmt::format("set key bottom right\nset xlabel 'displacement u ({})'\nset ylabel 'lateral load H ({})'\n", length.name, force.name);
  script += "plot 'lateral.dat' using 1:3 with lines lw 0.5 lc rgb push notitle, \\\n     'lateral_mean.dat' using 1:2 with lines lw 2.5 "
            "lc rgb push title "
            "'at the seabed', \\\n     'lateral.dat' using 2:3 with lines lw 1 dt 2 lc rgb drag title 'at the load'\nunset label 1\n";
  script += soil_plot::margins({0.58, 0.97, 0.17, 0.88});
  script += fmt::format("set xlabel 'tilt (°)'\nset ylabel 'moment at the seabed M ({} m)'\n", force.name);
  script += "plot 'lateral.dat' using 4:5 with lines lw 2 lc rgb push notitle\nunset multiplot\n";
  return plot::draw(folder.path(), "curves", soil_plot::panels_width, soil_plot::panels_height / 2, script);
}

std::vector<std::string> draw_lateral_figures(const LateralRuns& runs, const std::string& name, const std::filesystem::path& folder)
{
  const auto [length, force] = units_of(runs);
  plot::Figure load{"Lateral load over the displacement at the seabed",
                    fmt::format("u at the seabed ({})", length.name),
                    fmt::format("H ({})", force.name),
                    {},
                    plot::from_zero};
  plot::Figure moment{"Moment at the seabed over the tilt", "tilt (°)", fmt::format("M ({} m)", force.name), {}, plot::from_zero};
  for (const LateralRun& run : runs) {
    if (run.empty()) continue;
    const std::string style = plot::curve_style(run.number, run.number);
    load.curves.push_back({run.record.name, style, plot::scaled(run.path.u, length.per_si), plot::scaled(run.path.H, force.per_si)});
    moment.curves.push_back({run.record.name, style, plot::scaled(run.path.tilt, 1 / degree), plot::scaled(run.path.M, force.per_si)});
  }
  std::vector<std::string> drawn;
  for (const auto& [figure, ending] : {std::pair{&load, "_H_u"}, {&moment, "_M_tilt"}})
    if (!figure->curves.empty() && draw_png_and_svg(folder, name + ending, *figure)) drawn.push_back(name + ending);
  for (const LateralRun& run : runs)
    for (std::string& py : draw_py_figure(run, fmt::format("{}_p_y_{}", name, run.number), folder)) drawn.push_back(std::move(py));
  return drawn;
}

}  // namespace berm::lateral
