// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm {

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

/// Whether a rigid body turns.
enum class Rotation {
  fixed,
  free  ///< about its centre (in space: about z), by the moment of its contacts
};

/// A rigid body as the user gives it. It rests where no stage drives it.
struct RigidSettings {
  RigidShapeSettings shape;
  Real mass = 0;  ///< kg per metre run (in space: kg); needed where a force drives it
  Rotation rotation = Rotation::fixed;
  std::optional<Real>
      moment_of_inertia;  ///< kg m2 per metre run (in space: kg m2) about its centre; absent: a solid of this shape and mass
};

void describe(Describe& d, CircleSettings& circle);
void describe(Describe& d, HalfPlaneSettings& plane);
void describe(Describe& d, BoxSettings& box);
void describe(Describe& d, PolygonSettings& polygon);
void describe(Describe& d, RigidSettings& rigid);

}  // namespace berm
