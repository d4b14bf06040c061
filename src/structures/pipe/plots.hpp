// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plot/gnuplot.hpp"
#include "run_folder/frame.hpp"
#include "run_folder/run_folder.hpp"
#include "structures/pipe/pipe_quantities.hpp"

namespace berm::pipe {

/// curves.png: V(w) of the push, H(u) and w(u) of the drag (as far as there are both), with dimensionless axes beside. Thin: every row; thick:
/// freed from noise over +-0.01 D. False, with a warning, where it could not be drawn.
bool draw_pipe_curves(const run_folder::RunFolder& folder, const run_folder::History& history, const PipeScale& scale,
                      const PipeStages& stages, const std::string& title);

/// curves.png of any run: the columns named against time, one panel for each unit.
bool draw_columns(const run_folder::RunFolder& folder, const run_folder::History& history, const std::vector<std::string>& columns,
                  const std::string& title);

/// "tip_x_m" in two: what it is ("tip x") and the unit that the name ends with ("m"); "1" where it ends with none.
std::pair<std::string, std::string> name_and_unit(const std::string& column);

/// What colours the soil.
enum class SoilColor { deviatoric_strain, incremental_deviatoric_strain };

/// The part of the soil that a picture shows.
struct SoilView {
  Vec<2> lower, upper;          ///< m
  std::optional<Real> surface;  ///< m, level of the original surface, drawn as a dashed line
};

/// The view around a pipe: its axis at `x`, its lowest point at `lowest`, m.
SoilView view_around_pipe(Real x, Real lowest, Real diameter, Real surface);

/// A picture of the soil: NAME.png or NAME.svg.
struct SoilPicture {
  std::string name;
  SoilColor color;
  SoilView view;
  std::string title;
};

/// Particles as disks (in SVG as an image within it), or the triangles of the frame filled, coloured by the deviatoric strain of their displacement (since the start, or since the frame before);
/// rigid bodies grey, equal axes. The colours end at the value that one particle or node in a hundred exceeds. Script and data go to FOLDER/plots.
/// False, with a warning, where it could not be drawn.
bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<2>& frame, const SoilPicture& picture,
               plot::PlotFormat format = plot::PlotFormat::png);

}  // namespace berm::pipe
