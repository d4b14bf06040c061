// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid_settings.hpp"
#include "core/numbers.hpp"

namespace berm {

/// Distance and normal of a rigid surface as seen from a point.
template <int dim>
struct SurfacePoint {
  Real distance;    ///< m, negative inside the rigid body
  Vec<dim> normal;  ///< unit vector out of the rigid body
};

template <int dim>
struct Circle {
  Vec<dim> center;
  Real radius;
};
template <int dim>
struct HalfPlane {
  Vec<dim> point, normal;
};
template <int dim>
struct Box {
  Vec<dim> center, half;
  Matrix<dim> axes;  ///< columns: the directions of the sides
};
template <int dim>
using RigidShape = std::variant<Circle<dim>, HalfPlane<dim>, Box<dim>>;

template <int dim>
RigidShape<dim> make_shape(const RigidShapeSettings& settings);

/// The nearest point of the exact surface, for any point of space.
template <int dim>
SurfacePoint<dim> surface_at(const Circle<dim>& circle, const Vec<dim>& x);
template <int dim>
SurfacePoint<dim> surface_at(const HalfPlane<dim>& plane, const Vec<dim>& x);
template <int dim>
SurfacePoint<dim> surface_at(const Box<dim>& box, const Vec<dim>& x);
template <int dim>
SurfacePoint<dim> surface_at(const RigidShape<dim>& shape, const Vec<dim>& x)
{
  return std::visit([&](const auto& s) { return surface_at<dim>(s, x); }, shape);
}

/// The shape moved by `by`.
template <int dim>
RigidShape<dim> moved(const RigidShape<dim>& shape, const Vec<dim>& by);

/// The level y of its lowest point (of a half-plane: of its point).
template <int dim>
Real lowest_level(const RigidShape<dim>& shape);

/// Its centre (of a half-plane: its point).
template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape);

/// The length that results are made dimensionless with: diameter of a circle, width of a box, 0 for a half-plane.
template <int dim>
Real width_of(const RigidShape<dim>& shape);

/// A rigid body: where it is at the start and how heavy it is.
template <int dim>
struct Rigid {
  std::string name;
  RigidShape<dim> shape;
  Real mass;  ///< kg/m or kg
};

/// What changes of a rigid body.
template <int dim>
struct RigidState {
  Vec<dim> displacement = Vec<dim>::Zero();     ///< since the start, m
  Vec<dim> velocity = Vec<dim>::Zero();         ///< m/s, in force during the step
  Vec<dim> reaction = Vec<dim>::Zero();         ///< force of the soil on it in the last step, N/m or N
  Vec<dim> smooth_reaction = Vec<dim>::Zero();  ///< the same, averaged over about a hundred steps
  Vec<dim> impulse = Vec<dim>::Zero();          ///< what its contacts gave to the soil since the start (step 4), N s/m or N s
  Vec<dim> second_impulse = Vec<dim>::Zero();   ///< the same for the correction of step 8, which is no force
  Real pressed = 0;                             ///< sum of the magnitudes of all nodal impulses since the start, N s/m or N s
  Real pressed_distance =
      0;             ///< the same, each times the distance of the node's nearest particle from the surface; over pressed: the contact gap
  Real deepest = 0;  ///< m, how far a particle was inside the body since the last row of the history
};

}  // namespace berm
