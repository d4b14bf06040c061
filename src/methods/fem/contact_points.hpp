// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/quadratic_mesh.hpp"

#include <vector>

namespace berm::fem {

/// A node of the soil on the surface of a rigid body: one unilateral Coulomb constraint. The body is wished in place, so
/// all points are closed at first.
struct FemContactPoint {
  Index node;
  Vec<2> normal;      ///< unit, out of the rigid body into the soil; constant (small strain)
  Vec<2> arm;         ///< m, from the body's centre
  Real area;          ///< m2 per metre run, share of the surface
  Real adhesion = 0;  ///< Pa, before it slides
  Real friction = 0;  ///< coefficient
  Index contact = 0;  ///< in Model::contacts
};

/// State of a contact point.
struct FemContactState {
  Real gap = 0;                      ///< m; negative: overlap
  Vec<2> traction = Vec<2>::Zero();  ///< Pa, of the body on the soil
  Real slip = 0;                     ///< m, sliding distance along the surface
  Real parted = 0;                   ///< 1: has been pulled off, and carries tension no more
};

/// Penalty law of the interface: a normal spring of `stiffness` (Pa/m) in compression only, and a tangential one that slips
/// at friction times pressure + adhesion. At small pressure the adhesion is limited to ten times the pressure, so that the
/// shear does not jump where a point opens. The overlap is the error of the springs. A point that has not parted is bonded where
/// there is `tension`: its normal spring also pulls, with that stress at most, and its adhesion is whole.
struct FemInterface {
  Real friction = 0;       ///< coefficient
  Real adhesion = 0;       ///< Pa
  bool tied = false;       ///< neither slip nor separation
  Real stiffness = 0;      ///< Pa/m
  Real tension = 0;        ///< Pa; infinite: the surface never parts
  Real pore_pressure = 0;  ///< Pa, of the water at the surface: friction acts on the rest of the pressure
};

/// Whether a point that was bonded parts: its opening is more than what its tension stretches the spring by.
bool parts(const FemInterface& interface, const FemContactState& now);

/// A traction and its derivative with respect to the movement of the soil relative to the body (Pa/m).
struct FemTraction {
  FemContactState state;
  Matrix<2> stiffness;
};

/// The traction after a relative movement (soil - body, m) since `before`. A point with gap 0 is closed: it has a stiffness,
/// so that a force meets resistance at the start.
FemTraction update_traction(const FemInterface& interface, const Vec<2>& normal, const FemContactState& before, const Vec<2>& movement);

/// Relative movement of a contact point per movement of its node and of the rigid body (x, y, angle), by column.
Eigen::Matrix<Real, 2, 5> relative_movement(const FemContactPoint& point);

/// The contact points of sides that lie on the surface of the shape. Simpson's rule gives the areas; around an axis times the radius, and no point on it.
std::vector<FemContactPoint> make_contact_points(const std::vector<BoundarySide>& sides, const NodeField<Vec<2>>& position,
                                                 const bodies::RigidShape<2>& shape, mesh::Metric metric = mesh::Metric::cartesian);

}  // namespace berm::fem
