// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/ground_line.hpp"
#include "plot/gnuplot.hpp"
#include "run_folder/frame.hpp"

#include <optional>

namespace berm::soil_plot {

/// The part of the soil that a picture shows.
struct SoilView {
  Vec<2> lower, upper;           ///< m
  std::optional<Real> surface;   ///< m, level of the original surface, drawn as a dashed line
  mesh::GroundLine ground = {};  ///< instead, where that is not level
  bool mirrored = false;         ///< around the axis x = 0, whose other side is shown too

  /// Shows a ground that is not level as far as it lies in the view; nothing changes where it is level.
  void show(const mesh::GroundLine& line);
  /// Shows both sides of the axis x = 0 of soil that is computed at x >= 0.
  void mirror();
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

/// Particles as the ellipses that circles have become (particle_shapes.hpp), or the triangles of the frame filled, coloured by a field; rigid bodies grey, equal
/// axes. The colours span from zero to the value that one particle or node in a hundred exceeds. Script and data go to FOLDER/plots.
/// False, with a warning, where it could not be drawn.
bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<2>& frame, const SoilPicture& picture,
               plot::PlotFormat format = plot::PlotFormat::png);

/// What a picture in space shows: what lies in a box, whose side of largest z is the cut that is looked at.
struct SpaceView {
  Vec<3> lower, upper;    ///< m
  bool mirrored = false;  ///< the soil's other half, behind a plane of symmetry at `upper` z, is shown instead of the one that was computed
};

/// The view around a rigid body with this surface, cut along its middle: as far beside it as two and a half times its width, m, but not beyond the mesh.
/// mirrored: the mesh ends at a plane of symmetry at its lowest z.
SpaceView view_around(const bodies::SurfaceMesh<3>& body, Real width, const Vec<3>& mesh_lower, const Vec<3>& mesh_upper, bool mirrored);

/// The view of all of a mesh, cut along its middle.
SpaceView view_of_all(const Vec<3>& mesh_lower, const Vec<3>& mesh_upper, bool mirrored);

/// A picture of the soil in space: NAME.png.
struct SpacePicture {
  std::string name;
  std::string field;  ///< of the frame, one number a point, that colours the soil
  SpaceView view;
  std::string title;
};

/// Particles as balls in an isometric picture, coloured as in the plane by a field, and rigid bodies grey; what lies behind is hidden. Three arrows show the
/// axes and the scale. Script and data go to FOLDER/plots. False, with a warning, where it could not be drawn, and where no soil is in the view.
bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<3>& frame, const SpacePicture& picture);

}  // namespace berm::soil_plot
