// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/kind.hpp"

namespace berm::penetration {

/// The ends of the soil along x and below, m; infinite where they are not known.
struct Walls {
  Real left = -infinity, right = infinity, base = -infinity;
};

/// Of a mesh that berm makes. Of one of Gmsh only a wall through the middle of the body, a plane of symmetry, on one side of which the first frame has no soil.
Walls walls_of(const record::RunRecord& run, const base::BodyProfile& body);

/// In space, the part of a body around an axis at x and z (m) whose force the history has: 1, or 0.5 or 0.25 where walls of the soil go through that axis. Planes
/// that the case names as of symmetry take nothing: there the history has the force of the whole.
Real part_in_space(const record::RunRecord& run, const base::BodyProfile& body, Real z);

}  // namespace berm::penetration
