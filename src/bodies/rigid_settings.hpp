// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::bodies {

/// A circle, in space an endless cylinder along z.
struct CircleSettings {
  std::vector<Real> center;  ///< m
  Real diameter = 0;         ///< m
};

/// Everything on one side of a plane.
struct HalfPlaneSettings {
  std::vector<Real> point;   ///< m, on the surface
  std::vector<Real> normal;  ///< points out of the rigid body; any length
};

/// A rectangle (2D: may be turned) or box.
struct BoxSettings {
  std::vector<Real> center, size;  ///< m
  Real angle = 0;                  ///< rad, counter-clockwise; 2D only
};

/// A polygon, convex or not, in space an endless prism along z. Its corners in order, either way round.
struct PolygonSettings {
  std::vector<Real> x, y;  ///< m
};

using RigidShapeSettings = std::variant<CircleSettings, HalfPlaneSettings, BoxSettings, PolygonSettings>;

/// Whether at least three corners with different places make a polygon whose sides meet at its corners only.
bool is_simple(const PolygonSettings& polygon);

/// What a rigid body does where no stage drives it.
enum class Motion {
  driven,  ///< it rests
  free     ///< gravity and its contacts move it; in a geostatic stage it rests
};

/// Whether a rigid body turns.
enum class Rotation {
  fixed,
  free  ///< about its centre (in space: about z), by the moment of its contacts
};

/// A rigid body as the user gives it.
struct RigidSettings {
  RigidShapeSettings shape;
  Real mass = 0;  ///< kg per metre run (in space: kg); needed where a force moves it
  Motion motion = Motion::driven;
  Rotation rotation = Rotation::fixed;
  std::optional<Real> moment_of_inertia;  ///< kg m (in space: kg m2) about its centre; absent: that of a solid of this shape and mass
};

void describe(Describe& d, CircleSettings& circle);
void describe(Describe& d, HalfPlaneSettings& plane);
void describe(Describe& d, BoxSettings& box);
void describe(Describe& d, PolygonSettings& polygon);
void describe(Describe& d, RigidSettings& rigid);

}  // namespace berm::bodies
