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

using RigidShapeSettings = std::variant<CircleSettings, HalfPlaneSettings, BoxSettings>;

/// A rigid body as the user gives it. It moves only where a stage drives it.
struct RigidSettings {
  RigidShapeSettings shape;
  Real mass = 0;  ///< kg per metre run (in space: kg); needed where a force drives it
};

void describe(Describe& d, CircleSettings& circle);
void describe(Describe& d, HalfPlaneSettings& plane);
void describe(Describe& d, BoxSettings& box);
void describe(Describe& d, RigidSettings& rigid);

}  // namespace berm
