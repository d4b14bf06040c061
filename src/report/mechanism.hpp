// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/frame_reader.hpp"
#include "report/run_record.hpp"

#include <optional>

namespace berm {

/// Where the pipe is, m.
struct PipePlace {
  Real x;     ///< of its centre
  Real u, w;  ///< as in the history
};

/// The soil that lies above the original surface.
struct Heave {
  Real behind, ahead;  ///< m, highest column of soil within 1.5 D of the pipe's axis, on the side x < and x > its centre
  Real berm;           ///< m2, area of the soil above the surface ahead of the centre
};

/// Columns are D/10 wide and hold the soil's volume above the `surface` (m): a grain that was thrown up counts as the soil that it is.
Heave heave_of(const SavedSoil& soil, Real surface, const PipePlace& pipe, Real diameter);

/// Where soil shears between two frames.
struct Shearing {
  Real behind;  ///< part of the deviatoric strain (by volume) on the side x < the pipe's centre
  Real above;   ///< part of it above the original surface
  Real reach;   ///< m, distance ahead of the centre within which nine tenths of the part ahead lie
};

/// Of the growth of the accumulated deviatoric strain from one frame to another with the same points.
Shearing shearing_of(const SavedSoil& before, const SavedSoil& after, Real surface, const PipePlace& pipe);

/// A run's frames with the place of the pipe in each; none without a pipe, without frames or in space.
class PipeFrames {
public:
  explicit PipeFrames(const RunRecord& run);

  std::size_t count() const { return files_.size(); }
  const PipePlace& place(std::size_t frame) const { return places_[frame]; }
  /// The frame of the pushes or drags of this kind in which the quantity is nearest to `value`; empty where there is none.
  std::optional<std::size_t> nearest(StageKind kind, Real PipePlace::*quantity, Real value) const;
  /// The last frame of the stages of this kind.
  std::optional<std::size_t> last(StageKind kind) const;
  /// Throw RunError where the frame's file is missing or damaged.
  SavedSoil soil(std::size_t frame) const { return read_soil(files_[frame].soil); }
  SavedRigids rigids(std::size_t frame) const { return read_rigids(files_[frame].rigid); }

private:
  std::vector<FrameFiles> files_;
  std::vector<PipePlace> places_;
  std::vector<StageKind> kinds_;
};

}  // namespace berm
