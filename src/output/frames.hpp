// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/rigid_surface.hpp"
#include "problem/model.hpp"

#include <filesystem>

namespace berm {

/// A particle as a frame shows it.
template <int dim>
struct FrameParticle {
  Particle<dim> particle;
  Index body;
  Vec<dim> displacement;  ///< since the start, m
  Real strain_increment;  ///< of the accumulated deviatoric strain, since the frame before
};

/// What one frame shows: the particles by body and then id, and the rigid bodies where they are.
template <int dim>
struct Frame {
  Real time = 0;  ///< s
  std::vector<FrameParticle<dim>> particles;
  std::vector<RigidSurface<dim>> rigids;
};

/// Writes the frames of a run for ParaView: mesh.vtu once; at each frame particles_NNNN.vtu, rigid_NNNN.vtu where there are rigid bodies, and
/// frames.pvd, which lists all frames so far. Every file is written whole. Errors are RunErrors.
/// Fields of the particles: velocity (m/s), displacement (m), stress (Pa, tension positive, XX YY ZZ XY YZ XZ), mean_stress (Pa, tension
/// positive), deviatoric_strain (accumulated), incremental_deviatoric_strain (since the frame before), volume (m2 or m3), body, id.
template <int dim>
class FrameWriter {
public:
  /// Remembers where the particles of `start` are, and keeps the model, which must outlive it. Makes the folder where it is missing.
  FrameWriter(const std::filesystem::path& folder, const Model<dim>& model, const State<dim>& start);

  /// Writes one frame, unless the last one is of the same time.
  void write(const State<dim>& state);

  Index count() const { return static_cast<Index>(times_.size()); }
  /// The last frame written.
  const Frame<dim>& last() const { return last_; }

private:
  struct First {
    Vec<dim> x = Vec<dim>::Zero();
    Real strain = 0;  ///< at the frame before
  };
  Frame<dim> frame_of(const State<dim>& state);
  void write_mesh() const;
  void write_particles(const std::string& name) const;
  void write_rigids(const std::string& name, const State<dim>& state) const;
  void write_collection() const;

  std::filesystem::path folder_;
  const Model<dim>& model_;
  std::vector<std::vector<First>> first_;  ///< by body, then id
  std::vector<Real> times_;
  Frame<dim> last_;
};

}  // namespace berm
