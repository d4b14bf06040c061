// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/quadratic_mesh.hpp"

#include <vector>

namespace berm::fem {

/// A node of the soil on the surface of the rigid body: one unilateral Coulomb constraint. Wished in place, soil and body touch everywhere at first.
struct FemContactPoint {
  Index node;
  Vec<2> normal;  ///< unit, out of the rigid body into the soil; it stays (small strain)
  Vec<2> arm;     ///< m, from the body's centre
  Real area;      ///< m2 per metre run that the point stands for
};

/// What a contact point carries and how it stands.
struct FemContactState {
  Real gap = 0;                      ///< m; negative: how deep the soil is in the body
  Vec<2> traction = Vec<2>::Zero();  ///< Pa, of the body on the soil
};

/// The law of the interface. The normal is held by a spring of stiffness (Pa/m) that acts in compression only, the tangent by one that slides at
/// friction times pressure + adhesion. Under small pressure adhesion is ten times the pressure at most, so that the shear does not jump where a point
/// opens. How deep the soil is in the body measures the error of the springs.
struct FemInterface {
  Real friction = 0;    ///< coefficient
  Real adhesion = 0;    ///< Pa
  bool sticks = false;  ///< neither slides nor opens
  Real stiffness = 0;   ///< Pa/m
};

/// One traction and its derivative by the movement of the soil relative to the body (Pa/m).
struct FemTraction {
  FemContactState state;
  Matrix<2> stiffness;
};

/// The traction after a relative movement (soil - body, m) since `before`. A point whose gap is 0 is closed: it has a
/// stiffness, so that a force finds something to push against at the start.
FemTraction update_traction(const FemInterface& interface, const Vec<2>& normal, const FemContactState& before, const Vec<2>& movement);

/// Columns: how the node and the rigid body (x, y, angle) move a contact point's soil relative to the body.
Eigen::Matrix<Real, 2, 5> relative_movement(const FemContactPoint& point);

/// The contact points of sides that lie on the surface of the shape. Simpson's rule gives the areas.
std::vector<FemContactPoint> make_contact_points(const std::vector<BoundarySide>& sides, const NodeField<Vec<2>>& position,
                                                 const bodies::RigidShape<2>& shape);

}  // namespace berm::fem
