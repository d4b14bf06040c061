// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame.hpp"
#include "run_folder/gradient_strain.hpp"

namespace berm::run_folder {

/// A point of a frame with the fields that every frame has.
template <int dim>
struct FrameParticle {
  bodies::Particle<dim> particle;
  Index body;
  Vec<dim> displacement;
  GradientStrain strain;
  Real strain_increment;
};

/// A frame of such points.
template <int dim>
Frame<dim> frame_of(const std::vector<FrameParticle<dim>>& particles)
{
  Frame<dim> frame;
  frame.allocate(particles.size(), common_fields<dim>());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const FrameParticle<dim>& f = particles[k];
    frame.points[k] = f.particle.x;
    frame.volume[k] = f.particle.volume;
    frame.body[k] = f.body;
    frame.id[k] = f.particle.id;
    for (int d = 0; d < dim; ++d) frame.field("velocity").at(k, d) = f.particle.v[d];
    for (int d = 0; d < dim; ++d) frame.field("displacement").at(k, d) = f.displacement[d];
    for (int c = 0; c < tensor_size<dim>; ++c) frame.field("stress").at(k, c) = f.particle.stress[c];
    frame.field("mean_stress").at(k) = trace(f.particle.stress) / 3;
    frame.field("deviatoric_strain").at(k) = f.strain.deviatoric;
    frame.field("volumetric_strain").at(k) = f.strain.volumetric;
    frame.field("incremental_deviatoric_strain").at(k) = f.strain_increment;
    frame.field("accumulated_deviatoric_strain").at(k) = f.particle.deviatoric_strain;
  }
  return frame;
}

/// The points of a frame.
template <int dim>
std::vector<FrameParticle<dim>> particles_of(const Frame<dim>& frame)
{
  std::vector<FrameParticle<dim>> particles(frame.points.size());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    FrameParticle<dim>& f = particles[k];
    f.particle.x = frame.points[k];
    f.particle.volume = frame.volume[k];
    f.body = frame.body[k];
    f.particle.id = frame.id[k];
    for (int d = 0; d < dim; ++d) f.particle.v[d] = frame.field("velocity").at(k, d);
    for (int d = 0; d < dim; ++d) f.displacement[d] = frame.field("displacement").at(k, d);
    for (int c = 0; c < tensor_size<dim>; ++c) f.particle.stress[c] = frame.field("stress").at(k, c);
    f.strain = {frame.field("deviatoric_strain").at(k), frame.field("volumetric_strain").at(k)};
    f.strain_increment = frame.field("incremental_deviatoric_strain").at(k);
    f.particle.deviatoric_strain = frame.field("accumulated_deviatoric_strain").at(k);
  }
  return particles;
}

}  // namespace berm::run_folder
