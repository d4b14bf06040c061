// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/ground_line.hpp"
#include "plot/gnuplot.hpp"
#include "run_folder/frame.hpp"

#include <optional>

namespace berm::record {

/// The part of the soil that a picture shows.
struct SoilView {
  Vec<2> lower, upper;           ///< m
  std::optional<Real> surface;   ///< m, level of the original surface, drawn as a dashed line
  mesh::GroundLine ground = {};  ///< instead, where that is not level

  /// Shows a ground that is not level as far as it lies in the view; nothing changes where it is level.
  void show(const mesh::GroundLine& line);
};

/// The view around a rigid body: its centre at `x`, its lowest point at `lowest`, m. It reaches up to a berm of these points that stands in it, but for the highest
/// one in a thousand of them, which may be thrown up.
SoilView view_around(Real x, Real lowest, Real width, Real surface, const std::vector<Vec<2>>& soil);

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

}  // namespace berm::record
