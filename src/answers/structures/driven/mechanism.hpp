// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"
#include "structures/driven/driven_run.hpp"

#include <optional>

namespace berm::driven {

/// Where the pipe is, m.
struct BodyPlace {
  Real x;     ///< of its centre
  Real u, w;  ///< as in the history
};

/// How the surface has risen beside the pipe.
struct Heave {
  Real behind,
      ahead;  ///< m, largest rise (negative: it sinks) of a column of soil within 1.5 D of the pipe's axis, on the side x < and x > its centre
  Real berm;  ///< m2, area of the soil that has risen above the surface, ahead of the centre
};

/// Soil above the `surface` (m) now, less that at the `start`: columns are D/10 wide, each particle a square, so that a grain that was thrown up
/// counts for the soil that it is; of finite elements what lies below the ground.
Heave heave_of(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const problem::BedSurface& surface,
               const BodyPlace& pipe, Real diameter);

/// The berm ahead of a pipe that is dragged along `direction` (+1 or -1): the highest rise of a column of soil within 4 D of the pipe's axis, the distance
/// of that column's middle from the axis, m.
struct Berm {
  Real height, distance;
};
Berm berm_of(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const problem::BedSurface& surface,
             const BodyPlace& pipe, Real direction, Real diameter);

/// Clay whose plastic shear strain exceeds a limit.
struct RemouldedClay {
  Real depth;  ///< m below the invert, of the deepest below the pipe; 0 where none is
  Real area;   ///< m2, of all of it
};
RemouldedClay remoulded_clay(const run_folder::SavedSoil& now, Real limit, Real invert, const BodyPlace& pipe, Real diameter);

/// What moves between two frames with the same points, the one right before the other.
struct Mechanism {
  Real behind;  ///< part of the shearing (deviatoric strain times volume) on the side x < the pipe's centre
  Real reach;   ///< m, distance ahead of the centre within which nine tenths of the shearing ahead lie
  Real
      dragged;  ///< part of the soil above the surface, ahead of the centre, that moves along by at least a tenth of the pipe's way; NaN without any
};

/// Of the soil within 4 D of the pipe's axis. Strain of less than a tenth of what one point in a hundred exceeds there does not count: everywhere
/// else the soil shakes a little. Throws RunError where the points are not the same.
Mechanism mechanism_of(const run_folder::SavedSoil& before, const run_folder::SavedSoil& after, const problem::BedSurface& surface,
                       const BodyPlace& from, const BodyPlace& to, Real diameter);

/// A run's frames with the place of the pipe in each; none without a pipe, without frames that can be told or in space.
class BodyFrames {
public:
  explicit BodyFrames(const DrivenRun& run);

  std::size_t count() const { return files_.size(); }
  const BodyPlace& place(std::size_t frame) const { return places_[frame]; }
  /// The frame of the pushes or drags of this kind in which the quantity is nearest to `value`; empty where there is none.
  std::optional<std::size_t> nearest(settings::StageKind kind, Real BodyPlace::*quantity, Real value) const;
  /// The last frame of the stages of this kind, and of the stage of this name.
  std::optional<std::size_t> last(settings::StageKind kind) const;
  std::optional<std::size_t> last(const std::string& stage) const;
  /// Throw RunError where the frame's file is missing or damaged.
  run_folder::SavedSoil soil(std::size_t frame) const { return run_folder::read_soil(files_[frame].soil); }
  run_folder::SavedRigids rigid_bodies(std::size_t frame) const { return run_folder::read_rigids(files_[frame].rigid); }

private:
  std::vector<run_folder::FrameFiles> files_;
  std::vector<BodyPlace> places_;
  std::vector<settings::StageKind> kinds_;
  std::vector<std::string> stages_;
};

/// Adds to each drag the berm at its end, and the clay that it has remoulded, as far as there are frames that can be read.
void take_berms(Results& results, const DrivenRun& run);

}  // namespace berm::driven
