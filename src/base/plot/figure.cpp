// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_plot/soil_plot_test.cpp
#include "plot/figure.hpp"

#include "io/atomic_file.hpp"
#include "text/base64_zlib.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::plot {
namespace {

constexpr const char* colors[curve_colors] = {"#1764ab", "#c8452f", "#2f8f4e", "#8155a6", "#c98a16", "#4a4a4a", "#2aa5b5", "#d3649f"};
constexpr const char* dashes[curve_dashes] = {"solid", "'-'", "'.'", "'_.'"};

std::string block(const FigureCurve& curve)
{
  std::string text;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    text += std::isfinite(curve.x[k]) && std::isfinite(curve.y[k]) ? fmt::format("{:.9g} {:.9g}\n", curve.x[k], curve.y[k]) : "\n";
  return text;
}

}  // namespace

std::string curve_style(std::size_t color, std::size_t dash, Real width)
{
  return fmt::format("lines lw {} lc rgb '{}' dt {}", width, curve_color(color), dashes[dash % curve_dashes]);
}

const char* curve_color(std::size_t color)
{
  return colors[color % curve_colors];
}

bool draw_figure(const std::filesystem::path& folder, const std::string& name, const Figure& figure, PlotFormat format)
{
  const auto has_points = [](const FigureCurve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      if (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k])) return true;
    return false;
  };
  std::string plot;
  io::make_inner_folder(folder, "plots");
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    const FigureCurve& curve = figure.curves[k];
    if (!has_points(curve)) continue;
    const std::string data = fmt::format("{}_{}.dat", name, k);
    io::write_atomically(folder / "plots" / data, block(curve));
    plot += fmt::format("{}{} using 1:2 with {} {}", plot.empty() ? "plot " : ", \\\n     ", gnuplot_text("./" + data), curve.style,
                        curve.title.empty() ? "notitle" : "title " + gnuplot_text(curve.title));
  }
  if (plot.empty()) return false;
  const std::string script =
      fmt::format("set title {} font 'DejaVu Sans,14'\nset xlabel {}\nset ylabel {}\n"
                  "set autoscale xfix\nset format '%g'\nset grid lc rgb '#dddddd' lt 1\nset border lc rgb '#444444'\n"
                  "set tics nomirror textcolor rgb '#222222'\n"
                  "set key outside right top samplen 3 spacing 1.2\n{}{}\n",
                  gnuplot_text(figure.title), gnuplot_text(figure.x_label), gnuplot_text(figure.y_label), figure.more, plot);
  return draw(folder, name, figure.width, figure.height, script, format);
}

bool draw_png_and_svg(const std::filesystem::path& folder, const std::string& name, const Figure& figure)
{
  return draw_figure(folder, name, figure, PlotFormat::png) && draw_figure(folder, name, figure, PlotFormat::svg);
}

std::vector<Real> scaled(std::vector<Real> values, Real factor)
{
  for (Real& value : values) value *= factor;
  return values;
}

Real largest_size(const std::vector<Real>& values)
{
  Real max = 0;
  for (const Real value : values)
    if (std::isfinite(value)) max = std::max(max, std::abs(value));
  return max;
}

std::string html_image(const std::filesystem::path& folder, const std::string& name, const std::string& alt)
{
  return fmt::format("<img src=\"data:image/png;base64,{}\" alt=\"{}\">\n", text::base64(io::read_text_file(folder / (name + ".png"))),
                     text::html_text(alt));
}

}  // namespace berm::plot
