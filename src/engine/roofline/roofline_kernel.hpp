// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

namespace berm::roofline {

/// Result of the roofline kernel.
struct RooflineRun {
  BigIndex particles = 0, cells = 0, steps = 0;
  Real wall_s = 0;
  Real checksum = 0;  ///< of the stresses, Pa: so that no pass can be optimized away

  Real particle_steps_per_s() const { return static_cast<Real>(particles * steps) / wall_s; }
};

/// The roofline kernel: the passes of an explicit step of the material point method on linear triangles (dim 2) or tetrahedra (3) and nothing else, for at
/// least `seconds`. Sums of each cell to its nodes; their accelerations to the cells, and the momentum that follows back; in one pass over the particles
/// velocities, positions, strain, the return to a strength with friction, whether each particle is still inside, and the sums for the next step. No contact, smoothing, damping or corners of the surface, and no particle changes
/// its cell: the ceiling that the speed of berm is compared with. About `particles` of them, `per_cell` in each cell, in blocks of eight lanes.
template <int dim>
RooflineRun run_roofline_kernel(BigIndex particles, int per_cell, Real seconds);

/// Bandwidth of a[i] = b[i] + s c[i], bytes/s, over arrays of `bytes` in all, larger than the caches, for at least
/// `seconds`.
Real triad_bandwidth(BigIndex bytes, Real seconds);

}  // namespace berm::roofline
