// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape.hpp"

namespace berm::bodies {

/// Motion of a rigid body where no stage drives it.
enum class Motion {
  driven,  ///< at rest
  free     ///< by gravity and its contacts; at rest in a geostatic stage
};

/// Whether a rigid body rotates.
enum class Rotation {
  fixed,
  free  ///< about its centre, by the moment of its contacts
};

/// Input of a rigid body.
struct RigidSettings {
  RigidShapeSettings shape;
  Real mass = 0;  ///< kg per metre run (in space: kg); needed where a force moves it
  Motion motion = Motion::driven;
  std::vector<Real> velocity;  ///< m/s, of a free body where its first stage that is not geostatic begins; empty: at rest
  Rotation rotation = Rotation::fixed;
  std::optional<Real>
      moment_of_inertia;  ///< kg m (in space: kg m2, about every axis) about its centre; absent: that of a solid of this shape and mass
  int depth_slices = 0;   ///< of its height in the soil at the start, over which the soil's forces are told apart
  std::string structure = "automatic";  ///< what it is to the reader of its results (structures/structures.hpp)
};

void describe(Describe& d, RigidSettings& rigid);

/// Checks beyond the range of a single key, for the table at `path` ("rigid.pipe") of a case with this dimension.
void check(Describe& d, const std::string& path, const RigidSettings& rigid, int dimension);

}  // namespace berm::bodies
