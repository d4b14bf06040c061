// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape.hpp"

namespace berm::bodies {

/// What a rigid body does where no stage drives it.
enum class Motion {
  driven,  ///< it rests
  free     ///< gravity and its contacts move it; in a geostatic stage it rests
};

/// Whether a rigid body turns.
enum class Rotation {
  fixed,
  free  ///< about its centre, by the moment of its contacts
};

/// A rigid body as the user gives it.
struct RigidSettings {
  RigidShapeSettings shape;
  Real mass = 0;  ///< kg per metre run (in space: kg); needed where a force moves it
  Motion motion = Motion::driven;
  Rotation rotation = Rotation::fixed;
  std::optional<Real>
      moment_of_inertia;  ///< kg m (in space: kg m2, about every axis) about its centre; absent: that of a solid of this shape and mass
};

void describe(Describe& d, RigidSettings& rigid);

/// What no range of a single key can say, for the table at `path` ("rigid.pipe") of a case with this dimension.
void check(Describe& d, const std::string& path, const RigidSettings& rigid, int dimension);

}  // namespace berm::bodies
