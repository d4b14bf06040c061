// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"
#include "run_folder/gradient_strain.hpp"
#include "run_folder/rigid_surface.hpp"

namespace berm::run_folder {

/// A particle, or a node of a mesh of finite elements, as a frame shows it.
template <int dim>
struct FrameParticle {
  bodies::Particle<dim> particle;
  Index body;
  Vec<dim> displacement;  ///< since the start, m
  GradientStrain strain;  ///< of the gradient of the displacement
  Real strain_increment;  ///< deviatoric, of the gradient of the displacement since the frame before
};

/// A rigid body as a frame shows it.
template <int dim>
struct FrameRigid {
  RigidSurface<dim> surface;
  Vec<dim> velocity;  ///< m/s
};

/// What one frame shows: the particles by body and then id, and the rigid bodies where they are. Where finite elements carry the soil the particles
/// are their nodes, each with the area that belongs to it as its volume.
template <int dim>
struct Frame {
  Real time = 0;  ///< s
  std::vector<FrameParticle<dim>> particles;
  std::vector<std::array<Index, 6>>
      triangles;  ///< quadratic, of particles: corners counter-clockwise, middles of sides 01 12 20; none in MPM
  std::vector<FrameRigid<dim>> rigid_bodies;
};

/// The model's rigid bodies where `rigids` says that they are; a half-plane as far as the mesh reaches.
template <int dim>
std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>& model, const std::vector<bodies::RigidState<dim>>& rigid_bodies);

}  // namespace berm::run_folder
