// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plot/gnuplot.hpp"

#include <vector>

namespace berm::plot {

/// A line's style by two numbers, below these counts: colours differ for most eyes, also in their lightness.
constexpr std::size_t curve_colors = 8, curve_dashes = 4;
std::string curve_style(std::size_t color, std::size_t dash, Real width = 2);
/// The colour alone: "#1764ab".
const char* curve_color(std::size_t color);

/// One line of a figure, broken where a number is NaN.
struct FigureCurve {
  std::string title;  ///< in the key; "" = not there
  std::string style;  ///< as gnuplot's `with` takes it: "lines lc rgb 'black'"
  std::vector<Real> x, y;
};

/// A figure of curves over one another.
struct Figure {
  std::string title, x_label, y_label;
  std::vector<FigureCurve> curves;
  std::string more;  ///< gnuplot commands before the plot
  int width = 1000, height = 460;
};

/// Draws FOLDER/NAME.png or .svg, with the key beside the curves; its script and data go to FOLDER/plots. False, with a warning, where it could not be drawn
/// (see draw) or where there is nothing to draw.
bool draw_figure(const std::filesystem::path& folder, const std::string& name, const Figure& figure, PlotFormat format = PlotFormat::png);

/// FOLDER/NAME.png as an image of a page that needs no other file. Throws RunError where it cannot be read.
std::string html_image(const std::filesystem::path& folder, const std::string& name, const std::string& alt);

/// The same as both.
bool draw_png_and_svg(const std::filesystem::path& folder, const std::string& name, const Figure& figure);

/// Figure::more of a figure whose key stands below and whose y begins at 0, or at the least number where that is negative.
constexpr const char* from_zero = "set key below\nset yrange [*<0:*]\n";

/// Numbers times a factor; the largest absolute value of those that are finite, 0 without any.
std::vector<Real> scaled(std::vector<Real> values, Real factor);
Real largest_size(const std::vector<Real>& values);

}  // namespace berm::plot
