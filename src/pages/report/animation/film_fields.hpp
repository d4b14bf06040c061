// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"

namespace berm::report {

/// A field that colours the soil of a film: what it is in the frames' files, and what FilmData of web/src/data.ts calls it.
struct FilmField {
  std::string source;             ///< name in the files
  std::string name, label, unit;  ///< on the page
  Real factor;                    ///< of the files' numbers; of a vector's length
  bool summed;                    ///< the files tell it since the frame before
  bool spare;                     ///< goes where the page has no room, before frames do
};

/// The fields of a film, of all that the files hold numbers and vectors of: first those that are wanted most, the last ones go where the page has no room.
/// `body` is the word of the rigid body that is driven; "" where none is.
std::vector<FilmField> film_fields(const std::vector<run_folder::FieldValues<float>>& fields, const std::string& body);

/// What a film needs of a frame. Values by point; one that is not finite is 0.
struct FilmFrame {
  std::vector<Real> x, y;                  ///< m
  std::vector<Real> z;                     ///< m; empty but where all of a run in space is shown
  std::vector<float> flow_x, flow_y;       ///< m/s, flux of the water; empty where none flows, and where all of a run in space is shown
  std::vector<std::vector<float>> fields;  ///< as FilmReader::fields says; those that are summed from the first frame read on
  run_folder::SavedRigids rigid_bodies;
};

/// What a film of a run in space shows.
enum class FilmPart { slice, whole };

/// Most particles of a film of the whole of a run in space; of more, every n-th is shown.
constexpr Index max_in_space = 40'000;

/// Reads the frames of a run as its film shows them: all points in plane strain; in space those of the slice in the middle, or of the whole as many as `most`.
/// Where soil comes and goes the film has all points that any frame has. While one is not there it lies on one that is, the largest, and has its values, so that
/// it is not seen.
class FilmReader {
public:
  /// `body` is the word of the rigid body that is driven, or "". Reads the first frame, whose points all others must have; where soil comes and goes, all that can
  /// be read. Throws RunError where the first cannot be read or has no points.
  FilmReader(const std::vector<run_folder::FrameFiles>& files, int dimension, const std::string& body, bool soil_changes = false,
             FilmPart part = FilmPart::slice, Index most = max_in_space);

  /// What the first frame holds of fields.
  const std::vector<FilmField>& fields() const { return fields_; }

  std::size_t count() const { return chosen_.size(); }
  /// m, of the square or cube that each particle stands for at the start.
  const std::vector<float>& sizes() const { return sizes_; }
  /// Quadratic triangles of points; none in MPM.
  const std::vector<std::array<Index, 6>>& triangles() const { return first_.triangles; }
  /// Whether the frames have the flow of the water.
  bool has_flow() const { return has_flow_; }
  /// z of the slice, m.
  Real middle() const { return middle_; }
  /// One of so many particles is shown; 1: all.
  Index one_of() const { return one_of_; }

  /// Fields that are summed are those since the frame before it. Throws RunError where a file cannot be read or holds other points. Safe to call from several threads.
  FilmFrame read(const run_folder::FrameFiles& files) const;
  /// Adds to the fields of a frame that are summed those of one that is not shown.
  void add_summed(const run_folder::FrameFiles& files, FilmFrame& frame) const;

private:
  /// A frame, and where in it the points are that the film shows.
  struct Found {
    run_folder::SavedSoil soil;
    std::vector<Index> places;
    std::vector<bool> absent;  ///< that lie on another; empty: none does
  };
  void add_points_of(const std::vector<run_folder::FrameFiles>& files);
  Found find(const run_folder::FrameFiles& files) const;
  FilmFrame film_frame(const Found& found) const;
  std::vector<float> values(const Found& found, const FilmField& field) const;

  run_folder::SavedSoil first_;  ///< and behind its points those that come later: id, body, z and volume
  bool soil_changes_;
  std::vector<FilmField> fields_;
  std::vector<Index> chosen_;  ///< of these points, those that the film shows
  std::vector<float> sizes_;
  Real middle_ = 0;
  Index one_of_ = 1;
  bool with_z_ = false, has_flow_ = false;
};

}  // namespace berm::report
