// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"

namespace berm::report {

/// What a film needs of a frame. Values by point; one that is not finite is 0.
struct FilmFrame {
  std::vector<float> x, y;          ///< m
  std::vector<float> strain;        ///< deviatoric, of the displacement since the start
  std::vector<float> sheared;       ///< sum of the deviatoric strains of the displacements from frame to frame, from the first one read on
  std::vector<float> mean_stress;   ///< kPa, compression positive
  std::vector<float> speed;         ///< m/s
  std::vector<float> displacement;  ///< mm, since the start
  run_folder::SavedRigids rigid_bodies;
};

/// Reads the frames of a run as its film shows them: all points in plane strain, in space those of the slice in the middle.
class FilmReader {
public:
  /// Reads the first frame, whose points all others must have. Throws RunError where it cannot be read or has no points.
  FilmReader(const run_folder::FrameFiles& first, int dimension);

  std::size_t count() const { return chosen_.size(); }
  /// m, of the square or cube that each particle stands for at the start.
  const std::vector<float>& sizes() const { return sizes_; }
  /// Quadratic triangles of points; none in MPM.
  const std::vector<std::array<Index, 6>>& triangles() const { return first_.triangles; }
  /// z of the slice, m.
  Real middle() const { return middle_; }

  /// `sheared` is that since the frame before it. Throws RunError where a file cannot be read or holds other points. Safe to call from several threads.
  FilmFrame read(const run_folder::FrameFiles& files) const;
  /// Adds to `sheared` of a frame that of one that is not shown.
  void add_sheared(const run_folder::FrameFiles& files, FilmFrame& frame) const;

private:
  run_folder::SavedSoil same_soil(const run_folder::FrameFiles& files) const;
  FilmFrame film_frame(const run_folder::SavedSoil& soil) const;

  run_folder::SavedSoil first_;
  std::vector<Index> chosen_;  ///< points of the frames that the film shows
  std::vector<float> sizes_;
  Real middle_ = 0;
};

}  // namespace berm::report
