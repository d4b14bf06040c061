// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"

#include <optional>

namespace berm::bodies {

/// Where a rigid body is nearest to another.
template <int dim>
struct ProximityPoint {
  Vec<dim> position;  ///< m, on the surface of the second body
  Vec<dim> normal;    ///< unit vector out of the second body
  Real gap;           ///< m; negative where they overlap
};

/// What of a body comes to the surface of another first: points, each in the middle of a ball. The centre of a circle or a sphere, the corners of others in the plane.
template <int dim>
struct ContactCandidates {
  std::vector<Vec<dim>> points;  ///< m, at the start
  Real radius = 0;               ///< m, of the balls
};

/// How two rigid bodies meet: by the contact_candidates of one at the surface of the other, and the other way round where both have corners. Two straight sides that meet
/// do so at the corners of either.
template <int dim>
struct Proximity {
  ContactCandidates<dim> of_first, of_second;
};

/// Empty where berm cannot tell how they meet: in space each pair of bodies but a sphere and any other, two circles, and a circle and a half-plane; in the plane two
/// half-planes.
template <int dim>
std::optional<Proximity<dim>> proximity_of(const RigidShapeSettings& first, const RigidShapeSettings& second);

constexpr int max_proximity_points = 4;

/// The nearest points of two bodies there, at most max_proximity_points, farther ones than `reach` (m) left out. The normals point out of the second body.
template <int dim>
struct ProximityPoints {
  int count = 0;
  std::array<ProximityPoint<dim>, max_proximity_points> points;
};
template <int dim>
ProximityPoints<dim> proximity_points(const Proximity<dim>& proximity, const RigidBody<dim>& first, const Pose<dim>& first_pose,
                                      const RigidBody<dim>& second, const Pose<dim>& second_pose, Real reach);

}  // namespace berm::bodies
