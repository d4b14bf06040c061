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
  std::string field;  ///< of the frame, one number a point, that colours the soil
  SoilView view;
  std::string title;
};

/// Particles as disks (in SVG as an image within it), or the triangles of the frame filled, coloured by a field; rigid bodies grey, equal
/// axes. The colours span from zero to the value that one particle or node in a hundred exceeds. Script and data go to FOLDER/plots.
/// False, with a warning, where it could not be drawn.
bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<2>& frame, const SoilPicture& picture,
               plot::PlotFormat format = plot::PlotFormat::png);

}  // namespace berm::pipe
