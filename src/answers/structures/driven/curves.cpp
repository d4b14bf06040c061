// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/curves.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/panels.hpp"
#include "structures/base/display_units.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::driven {
namespace {

/// Lines of the file: x, and each value of the row and freed from noise.
std::string block(const std::vector<const base::Curve*>& columns, Real x_unit, const std::vector<Real>& units)
{
  std::string text;
  for (std::size_t k = 0; k < columns.front()->x.size(); ++k) {
    if (std::isnan(columns.front()->travel[k])) continue;  // the way down to the surface is of no interest
    text += fmt::format("{:.6g}", columns.front()->x[k] * x_unit);
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (const Real value : {columns[c]->y[k], columns[c]->smooth[k]})
        text += std::isnan(value) ? " NaN" : fmt::format(" {:.6g}", value * units[c]);
    text += '\n';
  }
  return text;
}

/// One axis of a panel from 0, or from the least number where that is negative by more than noise, to the most; in the plot's unit.
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
    constexpr Real noise = 0.05;  // of the range
    const Real margin = max > min ? 0.04 * (max - min) : 1, from = -min > noise * (max - min) ? min - margin : 0, to = max + margin;
    const auto range = [&](Real factor) {
      return fmt::format("[{:.6g}:{:.6g}]", factor * (downwards ? to : from), factor * (downwards ? from : to));
    };
    std::string words = fmt::format("set {0}label {1}\nset {0}range {2}\nset {0}tics {3:.6g}\n", letter, plot::gnuplot_text(label),
                                    range(1), plot::tic_step(to - from));
    if (second > 0)
      words += fmt::format("set {0}2label {1}\nset {0}2range {2}\nset {0}2tics {3:.6g}\n", letter, plot::gnuplot_text(second_label),
                           range(second), plot::tic_step(second * (to - from)));
    return words;
  }
};

constexpr const char* next_panel = "unset label\nunset x2tics\nunset x2label\nunset y2tics\nunset y2label\n";

/// The curves of a picture and the units that it shows them in.
struct Curves {
  const base::Charts& charts;
  const base::BodyScale& scale;
  plot::PlotUnit length, force;
  const std::vector<run_folder::CurveBand>& bands;

  const std::vector<base::Curve>& in(const char* chart) const { return curves_in(charts, chart); }
  const base::Curve& push() const { return in("V_w").front(); }
  bool has_push() const
  {
    return std::ranges::count_if(push().travel, [](Real w) { return w >= 0; }) > 1;
  }
  bool has_drag() const { return !in("H_u").empty() && in("H_u").front().x.size() > 1; }
};

/// curves.dat: a block of the push, then one of the drags, with an empty line between two of them. H is along x.
std::string data_of(const Curves& curves)
{
  const plot::PlotUnit &length = curves.length, &force = curves.force;
  const std::string units = fmt::format("({}, {})", length.name, force.name);
  std::string data = fmt::format("# push {}: w, V, V averaged\n", units);
  data += curves.has_push() ? block({&curves.push()}, length.per_si, {force.per_si}) : "NaN NaN NaN\n";
  data += fmt::format("\n\n# drags {}: u, H, H freed from noise, w, w freed from noise, V, V averaged\n", units);
  if (!curves.has_drag()) data += "NaN NaN NaN NaN NaN NaN NaN\n";
  for (std::size_t k = 0; k < curves.in("H_u").size(); ++k)
    data += (k == 0 ? "" : "\n") + block({&curves.in("H_u")[k], &curves.in("w_u")[k], &curves.in("V_u")[k]}, length.per_si,
                                         {force.per_si, length.per_si, force.per_si});
  return data;
}

/// A band as an outline that gnuplot fills: along its low side and back along the high one. "" where the chart has none.
std::string band_blocks(const Curves& curves, const std::string& chart)
{
  std::string data;
  const Real y_unit = chart == "w_u" ? curves.length.per_si : curves.force.per_si;
  for (const run_folder::CurveBand& band : curves.bands) {
    if (band.chart != chart) continue;
    std::string there, back;
    for (std::size_t k = 0; k < band.x.size(); ++k) {
      if (std::isnan(band.low[k]) || std::isnan(band.high[k])) continue;
      const Real x = band.x[k] * curves.length.per_si;
      there += fmt::format("{:.6g} {:.6g}\n", x, band.low[k] * y_unit);
      back.insert(0, fmt::format("{:.6g} {:.6g}\n", x, band.high[k] * y_unit));
    }
    if (!there.empty()) data += (data.empty() ? "" : "\n") + there + back;
  }
  return data;
}

/// The name of a band's file in plots/, and what draws it under the curves; "" without a band.
std::string band_script(const Curves& curves, const std::string& chart, const char* columns, const char* color)
{
  if (band_blocks(curves, chart).empty()) return "";
  return fmt::format("'band_{}.dat' using {} with filledcurves closed fs solid noborder lc rgb '{}' notitle, ", chart, columns, color);
}

constexpr const char* charts_with_bands[] = {"V_w", "H_u", "w_u"};
constexpr const char *push_band = "#dfe9f4", *drag_band = "#f8e3df";

/// Beside it the force over D s_u of clay, over gamma' D^2 of other soil.
Axis force_axis(const Curves& curves, char letter, const std::string& words, const char* symbol)
{
  const base::ForceMeasure measure = base::force_measure(curves.scale);
  return {.letter = letter,
          .label = fmt::format("{} {} ({})", words, symbol, curves.force.name),
          .downwards = false,
          .second = measure.size > 0 ? 1 / (measure.size * curves.force.per_si) : 0,
          .second_label = fmt::format("{}/({})", symbol, measure.kind == base::ForceMeasure::Kind::strength ? "D sᵤ" : "γ'D²")};
}

Axis length_axis(const Curves& curves, char letter, const std::string& words, const char* symbol, bool downwards)
{
  return {.letter = letter,
          .label = fmt::format("{} {} ({})", words, symbol, curves.length.name),
          .downwards = downwards,
          .second = 1 / (curves.scale.width * curves.length.per_si),
          .second_label = fmt::format("{}/D", symbol)};
}

/// V over w of the push.
std::string push_panel(const Curves& curves)
{
  Axis V = force_axis(curves, 'x', "vertical reaction", "V"), w = length_axis(curves, 'y', "embedment", "w", true);
  const base::Curve& push = curves.push();
  for (std::size_t k = 0; k < push.x.size(); ++k)
    if (push.travel[k] >= 0) V.take({push.y[k]}, curves.force.per_si), w.take({push.x[k]}, curves.length.per_si);
  for (const run_folder::CurveBand& band : curves.bands)
    if (band.chart == "V_w") V.take(band.low, curves.force.per_si), V.take(band.high, curves.force.per_si);
  const soil_plot::PanelPlace place =
      curves.has_drag() ? soil_plot::PanelPlace{0.075, 0.40, 0.085, 0.84} : soil_plot::PanelPlace{0.10, 0.88, 0.085, 0.84};
  std::string script = soil_plot::margins(place) + V.script() + w.script();
  script += "plot " + band_script(curves, "V_w", "2:1", push_band);
  script += "'curves.dat' index 0 using 2:1 with lines lc rgb '#b8d0ea' lw 1 notitle, \\\n"
            "     '' index 0 using 3:1 with lines lc rgb push lw 2.5 notitle\n";
  return script + next_panel;
}

/// From light to dark in the order of the drags; of one alone the colour `drag`.
std::string drag_color(std::size_t k, std::size_t count)
{
  constexpr std::array<int, 3> light{0xf2, 0x9c, 0x6b}, dark{0x7a, 0x12, 0x2b};
  if (count == 1) return "#c8452f";
  const Real part = static_cast<Real>(k) / static_cast<Real>(count - 1);
  std::string color = "#";
  for (std::size_t c = 0; c < 3; ++c) color += fmt::format("{:02x}", light[c] + static_cast<int>(part * (dark[c] - light[c])));
  return color;
}

/// One line for each drag, of two columns of the file; thin ones are its rows.
std::string drag_lines(std::size_t count, int column, bool thin)
{
  std::string lines;
  for (std::size_t k = 0; k < count; ++k)
    lines += fmt::format("{}'curves.dat' index 1 every :::{}::{} using 1:{} with lines lc rgb '{}' lw {} notitle", k == 0 ? "" : ", ", k, k,
                         column, thin ? "#f0c4bb" : drag_color(k, count), thin ? 1. : 2.5);
  return lines;
}

/// What the colours and the two kinds of lines mean, above the panels.
std::string legend(const Curves& curves)
{
  std::string words;
  int label = 10;
  const auto put = [&](Real x, const std::string& text, const std::string& color, const char* anchor) {
    words += fmt::format("set label {} {} at screen {:.3f},0.925 {} font 'DejaVu Sans,12' tc rgb '{}'\n", label++, plot::gnuplot_text(text),
                         x, anchor, color);
  };
  const std::size_t drags = curves.in("H_u").size();
  constexpr std::size_t max_names = 6;
  if (curves.has_push()) put(0.075, "━ push", "#1764ab", "left");
  if (drags > max_names) {
    put(0.30, "━ first drag", drag_color(0, drags), "left");
    put(0.46, fmt::format("━ last of {} drags", drags), drag_color(drags - 1, drags), "left");
  }
  for (std::size_t k = 0; k < drags && drags <= max_names; ++k)
    put(0.17 + 0.075 * static_cast<Real>(k), drags == 1 ? "━ drag" : fmt::format("━ drag {}", k + 1), drag_color(k, drags), "left");
  if (curves.scale.noisy) put(0.985, fmt::format("thin: rows; thick: mean over ±{:g} D", base::averaging_half_width), "#555555", "right");
  return words;
}

/// H over u, and below it w over u, of all drags.
std::string drag_panels(const Curves& curves)
{
  const Real left = curves.has_push() ? 0.565 : 0.10, right = curves.has_push() ? 0.915 : 0.88;
  const std::vector<base::Curve>& drags = curves.in("H_u");
  const bool both_ways = std::ranges::any_of(drags, [](const base::Curve& drag) { return drag.direction < 0; });
  Axis H = force_axis(curves, 'y', both_ways ? "reaction along x" : "horizontal resistance", "H"),
       w = length_axis(curves, 'y', "embedment", "w", true);
  Axis u = length_axis(curves, 'x', "horizontal displacement", "u", false);
  for (const base::Curve& drag : drags) H.take(drag.y, curves.force.per_si), u.take(drag.x, curves.length.per_si);
  for (const base::Curve& drag : curves.in("w_u")) w.take(drag.y, curves.length.per_si);
  for (const run_folder::CurveBand& band : curves.bands) {
    if (band.chart == "V_w") continue;
    Axis& axis = band.chart == "H_u" ? H : w;
    for (const std::vector<Real>* side : {&band.low, &band.high})
      axis.take(*side, band.chart == "H_u" ? curves.force.per_si : curves.length.per_si);
  }
  std::string script = soil_plot::margins({left, right, 0.52, 0.84}) + u.script() + H.script();
  script += "plot " + band_script(curves, "H_u", "1:2", drag_band);
  if (curves.scale.noisy) script += drag_lines(drags.size(), 2, true) + ", \\\n     ";
  script += drag_lines(drags.size(), 3, false) + '\n';
  u.second = 0;
  script += next_panel + soil_plot::margins({left, right, 0.085, 0.43}) + u.script() + w.script();
  return script + "plot " + band_script(curves, "w_u", "1:2", drag_band) + drag_lines(drags.size(), 5, false) + '\n';
}

}  // namespace

bool draw_run_curves(const run_folder::RunFolder& folder, const base::Charts& charts, const base::BodyScale& scale,
                     const std::string& title, const std::vector<run_folder::CurveBand>& bands)
{
  if (charts.empty()) return false;
  Real max = 0;
  for (const char* chart : {"V_w", "H_u", "V_u"})
    for (const base::Curve& curve : curves_in(charts, chart))
      for (std::size_t k = 0; k < curve.y.size(); ++k)
        if (!std::isnan(curve.travel[k])) max = std::max(max, plot::largest_size({curve.y[k]}));
  const Curves curves{charts, scale, plot::length_unit(scale.width), plot::force_unit(max, scale.dimension), bands};
  if (!curves.has_push() && !curves.has_drag()) return false;
  folder.subfolder("plots");
  io::write_atomically(folder.file("plots/curves.dat"), data_of(curves));
  for (const std::string chart : charts_with_bands)
    if (const std::string band = band_blocks(curves, chart); !band.empty())
      io::write_atomically(folder.file("plots/band_" + chart + ".dat"), band);
  std::string script = soil_plot::begin_panels(title) + legend(curves);
  if (curves.has_push()) script += push_panel(curves);
  if (curves.has_drag()) script += drag_panels(curves);
  return plot::draw(folder.path(), "curves", soil_plot::panels_width, soil_plot::panels_height, script + "unset multiplot\n");
}

}  // namespace berm::driven
