// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

namespace berm::roofline {

/// What the bare passes of a step did.
struct CeilingRun {
  BigIndex particles = 0, cells = 0, steps = 0;
  Real wall_s = 0;
  Real checksum = 0;  ///< of the stresses, Pa: so that no pass can be left out

  Real particle_steps_per_s() const { return static_cast<Real>(particles * steps) / wall_s; }
};

/// The ceiling: the passes of an explicit step of the material point method on linear triangles and nothing else, for at least `seconds`. Sums of
/// each cell to its nodes; accelerations to the particles and their momentum back; velocities to positions, strain, Mohr-Coulomb in the plane and
/// whether each particle is still inside. No contact, no smoothing, no damping, no corners of the surface, and no particle changes its cell: what berm does
/// beside these is measured against it. About `particles` of them, `per_cell` in each triangle, in blocks of eight lanes.
CeilingRun run_ceiling(BigIndex particles, int per_cell, Real seconds);

/// Bytes a second of a[i] = b[i] + s c[i] over arrays of `bytes` in all, larger than the caches, for at least `seconds`.
Real triad_bandwidth(BigIndex bytes, Real seconds);

}  // namespace berm::roofline
