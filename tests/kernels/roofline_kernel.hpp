// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"

namespace berm::roofline {

/// Result of the roofline kernel.
struct RooflineRun {
  BigIndex particles = 0, cells = 0, steps = 0;
  BigIndex lanes = 0;         ///< of the parts in which the passes took the particles, with those that hold none
  std::vector<Timing> loops;  ///< of all steps, by the labels of the loops of mpm/step.cpp that do the same and more
  Real wall_s = 0;
  Real checksum = 0;  ///< of the stresses: so that no pass can be optimized away

  Real particle_steps_per_s() const { return static_cast<Real>(particles * steps) / wall_s; }
};

/// The roofline kernel: the passes of an explicit step of the material point method on linear triangles (dim 2) or tetrahedra (3) and nothing else, for at
/// least `seconds`, on a copy of the particles as they lie in their cells. Forces of each cell to its nodes; their accelerations to the cells, and the momentum
/// that follows back; in one pass over the particles velocities, positions, strain, the return to a strength with friction, whether each particle is still
/// inside, and the sums for the next step. No contact, projection, filter, viscosity, damping or corners of the surface, and no particle changes its cell.
template <int dim>
RooflineRun run_roofline_kernel(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real seconds);

/// Bandwidth of a[i] = b[i] + s c[i], bytes/s, over arrays of `bytes` in all, larger than the caches, for at least
/// `seconds`.
Real triad_bandwidth(BigIndex bytes, Real seconds);

}  // namespace berm::roofline
