// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::depth {

/// The forces of the soil on a rigid body by depth below the bed (rigid.NAME.depth_slices) at the end of a stage: means over the last tenth of its time. Of a whole
/// body in N and N/m; in plane strain per metre run, in N/m and Pa.
struct Profile {
  std::string body, stage;
  bool whole = true;
  Real thickness = 0;   ///< m, of a slice
  std::vector<Real> h;  ///< by slice from the bed down, per metre of depth: horizontal force on the soil; empty around an axis
  std::vector<Real> v;  ///< the same: upward force on vertical sides; negative where soil that settles drags the body down
  std::vector<Real>
      axial;  ///< by level, above each slice and below the last: what comes from below, compression positive, without the body's own weight

  bool sideways = false;  ///< whether the stage loads the body along the bed: its neutral plane, of an axial load, is then of no meaning

  Real level(std::size_t k) const { return thickness * static_cast<Real>(k); }
  /// Drag load: the most that the axial force grows by from the bed down.
  Real drag_load() const;
  /// Depth from which on soil drags the body down no more, m: where the axial force is largest, within a thousandth of the drag load.
  Real neutral_plane() const;
};

/// Of all bodies with slices and all stages with rows, by body and stage.
std::vector<Profile> profiles(const record::RunRecord& run);

/// Shaft friction of a slice over the way down in a stage (a t-z curve), freed from noise: means over equal steps of the way.
struct TzCurve {
  std::string body, stage;
  bool whole = true;
  Real z = 0;           ///< m below the bed: the middle of the slice
  std::vector<Real> w;  ///< m, downwards since the start of the stage
  std::vector<Real> t;  ///< as Profile::v
};

/// Those of bodies that go up or down in a stage, by body, stage and slice.
std::vector<TzCurve> tz_curves(const record::RunRecord& run);

}  // namespace berm::depth
