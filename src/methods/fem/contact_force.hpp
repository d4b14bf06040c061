// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// What the interface does at a contact point: on x and y of its node, then x, y and angle of the rigid body.
struct ContactForce {
  FemContactState state;
  Vec<2> arm;                           ///< m, from the body's centre
  Eigen::Matrix<Real, 5, 1> force;      ///< N/m, and N m/m
  Eigen::Matrix<Real, 5, 5> stiffness;  ///< its derivative, N/m2; in large deformations without that of normal and arm
};

/// At the end of an increment in which node and body move by `moved` (m; rad). Where deformations are large, gap, normal and arm are those at the end, on the exact surface, and the shear stress of
/// the start rotates with the normal.
ContactForce contact_force(const FemModel& model, std::size_t point, const FemState& begin, const Eigen::Matrix<Real, 5, 1>& moved);

}  // namespace berm::fem
