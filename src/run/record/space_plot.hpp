// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame.hpp"

namespace berm::record {

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

}  // namespace berm::record
