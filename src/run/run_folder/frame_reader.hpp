// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame.hpp"
#include "run_folder/vtu.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace berm::run_folder {

/// The files of one frame.
struct FrameFiles {
  Real time = 0;                ///< s
  std::filesystem::path soil;   ///< particles_NNNN.vtu or soil_NNNN.vtu
  std::filesystem::path rigid;  ///< rigid_NNNN.vtu; empty where there is none
};

/// The frames that frames.pvd of a run's folder of frames lists, in their order; none where there is no such file. Throws RunError where it is damaged.
std::vector<FrameFiles> frame_files(const std::filesystem::path& frames_folder);

/// A frame as it was written: in space with three coordinates, in plane strain with z = 0. Fields in single precision; places in double, as survey
/// coordinates of seven digits need it.
struct SavedSoil {
  std::filesystem::path file;                   ///< that it was read from
  std::vector<Real> x, y, z;                    ///< m, by point: where it is now; finite
  std::vector<float> volume;                    ///< m2 in plane strain, m3 in space
  std::vector<std::int32_t> id, body;           ///< by point
  std::vector<FieldValues<float>> fields;       ///< all others that the file holds; vectors have three components, symmetric tensors six
  std::vector<std::array<Index, 6>> triangles;  ///< quadratic, of points; none in MPM

  /// The numbers of a field. Throws RunError with the file's name where there is none of that name.
  const std::vector<float>& operator[](const std::string& name) const;
};

/// The outline or surface of the rigid bodies: closed polygons and lines of points in plane strain.
struct SavedRigids {
  std::vector<Real> x, y, z;              ///< m, by point; finite
  std::vector<std::vector<Index>> cells;  ///< points of each cell
  std::vector<VtkCell> types;             ///< by cell
  std::vector<std::int32_t> rigid;        ///< by cell: the number of the rigid body, as in the case
};

/// Read the files of a frame. Throw RunError, with the file's name, where a file is missing, cut off or not one of a frame.
SavedSoil read_soil(const std::filesystem::path& file);
SavedRigids read_rigids(const std::filesystem::path& file);

}  // namespace berm::run_folder
