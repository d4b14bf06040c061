// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <filesystem>
#include <string>

namespace berm::plot {

/// A text as gnuplot takes it between single quotes, quotes included.
std::string gnuplot_text(const std::string& text);

/// The font of a text of one line, between quotes: of this size in points, or smaller where the text is longer than so many pixels.
std::string font_that_fits(const std::string& text, Real size, Real pixels);

/// The command that writes a title over the middle of a picture of this width; level: of its middle, in parts of the picture's height.
std::string title_over(const std::string& title, int width, Real level);

/// A length or force in the unit that suits its size.
struct PlotUnit {
  Real per_si;  ///< numbers in the plot per number in SI
  const char* name;
};
PlotUnit length_unit(Real size);                ///< mm below 1 m, else m
PlotUnit force_unit(Real size, int dimension);  ///< below 100 N/m N/m, else kN/m; of whole forces (dimension 3) N or kN

/// What a plot is written as.
enum class PlotFormat { png, svg };

/// Writes plots/NAME.gp (of an SVG NAME_svg.gp) and lets the program gnuplot make NAME.png or NAME.svg of it in the folder. The script runs in
/// plots/, beside its data, so that a user can change it and run it again there. width and height are in pixels. Where gnuplot is missing or
/// fails a warning says so and the result is false; a run never fails for want of a picture.
bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, const std::string& script,
          PlotFormat format = PlotFormat::png);

/// The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten, for the end of an axis or of a range of colours; 1 where there is nothing to show.
Real round_up(Real value);

/// What the numbers of an axis count from: 0, or a round number where the axis is so far from the origin that they would have no room.
Real axis_base(Real from, Real to);

/// The title of such an axis: x (mm), or x - 500000 m (mm).
std::string axis_title(const std::string& name, Real base, const std::string& unit);

/// 1, 2 or 5 times a power of ten, so that about five steps make the range.
Real tic_step(Real range);

}  // namespace berm::plot
