// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "run_folder/frame.hpp"
#include "run_folder/vtu.hpp"

#include <filesystem>
#include <functional>

namespace berm::run_folder {

/// Bytes of a point of the soil in the file of a frame of particles whose fields, beside the common ones, have so many numbers; those of its cell are counted. About:
/// how far they are compressed follows from how far the soil has moved.
template <int dim>
std::size_t bytes_of_point_in_file(int more_numbers);

/// Writes the frames of a run for ParaView: mesh.vtu once; at each frame particles_NNNN.vtu, or soil_NNNN.vtu where there are elements,
/// rigid_NNNN.vtu where there are rigid bodies, and frames.pvd, which lists all frames so far. Every file is written whole. Errors are RunErrors.
/// Particles or nodes have all fields of the Frame, each with its label and unit, and volume, body and id. Vectors have three components there,
/// symmetric tensors six (XX YY ZZ XY YZ XZ).
template <int dim>
class FrameWriter {
public:
  /// Makes the folder where it is missing and writes the mesh, unless another process does that.
  FrameWriter(const std::filesystem::path& folder, const mesh::Mesh<dim>& mesh, bool with_mesh = true);

  /// Writes one frame, unless the last one written is of the same time. All frames of a run have elements or none, rigid bodies or none.
  void write(const Frame<dim>& frame);
  /// Who compresses a frame: the thread that asks for it to be written, with its team, or the one that writes it.
  enum class Compress { now, later };
  /// The same in two parts: counts it among those written, and returns what writes its files, for any thread to call once and in order. The frame must be as it is until
  /// then. Empty where there is nothing to write.
  std::function<void()> write_later(const Frame<dim>& frame, Compress when = Compress::later);

  /// What a resumed run needs to continue after the frames so far. Reading refuses where one of their files is gone.
  void archive(Archive& k);
  const std::filesystem::path& folder() const { return folder_; }
  /// Removes frames that are not among those written: of a run that came farther than where it is resumed.
  void remove_others() const;

  /// Of the frames written, s.
  const std::vector<Real>& times() const { return times_; }

private:
  void write_mesh(const mesh::Mesh<dim>& mesh) const;
  std::function<void()> write_files(const Frame<dim>& frame, Index number) const;
  Vtu::Packed soil(const Frame<dim>& frame) const;
  Vtu::Packed rigids(const Frame<dim>& frame) const;
  void write_collection(const std::vector<Real>& times) const;
  std::vector<std::string> files() const;
  /// A thread that writes sees the same as the first frame was counted before.
  const char* soil_kind() const { return with_elements_ ? "soil" : "particles"; }

  std::filesystem::path folder_;
  std::vector<Real> times_;
  bool with_rigids_ = false, with_elements_ = false;
};

}  // namespace berm::run_folder
