// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid_settings.hpp"
#include "core/types.hpp"

#include <memory>

namespace berm::bodies {

/// The turn by an angle (rad, counter-clockwise) about z.
template <int dim>
Matrix<dim> turn(Real angle)
{
  Matrix<dim> q = Matrix<dim>::Identity();
  q(0, 0) = q(1, 1) = std::cos(angle);
  q(1, 0) = std::sin(angle);
  q(0, 1) = -q(1, 0);
  return q;
}

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
  Real angle = 0;  ///< rad, of a mark on it, for pictures
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
struct Polygon {
  Vec<dim> center;  ///< centroid
  Matrix<dim> axes;
  std::shared_ptr<const std::vector<Vec<2>>> corners;  ///< counter-clockwise, seen from the centroid along the axes
};
template <int dim>
using RigidShape = std::variant<Circle<dim>, HalfPlane<dim>, Box<dim>, Polygon<dim>>;

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
SurfacePoint<dim> surface_at(const Polygon<dim>& polygon, const Vec<dim>& x);
template <int dim>
SurfacePoint<dim> surface_at(const RigidShape<dim>& shape, const Vec<dim>& x)
{
  return std::visit([&](const auto& s) { return surface_at<dim>(s, x); }, shape);
}

/// The level y of its lowest point (of a half-plane: of its point).
template <int dim>
Real lowest_level(const RigidShape<dim>& shape);

/// Its centre (of a half-plane: its point).
template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape);

/// The length that results are made dimensionless with: diameter of a circle, width of a box or polygon, 0 for a
/// half-plane.
template <int dim>
Real width_of(const RigidShape<dim>& shape);

/// How far from its centre its surface reaches; 0 for a half-plane, which never turns.
template <int dim>
Real reach_of(const RigidShape<dim>& shape);

/// Moment of inertia of a solid of this shape about its centre (in space: about z), over its mass: m2. 0 for a half-plane.
template <int dim>
Real inertia_over_mass(const RigidShape<dim>& shape);

/// A rigid body: where it is at the start, how heavy it is and how it may move.
template <int dim>
struct RigidBody {
  std::string name;
  RigidShape<dim> shape;
  Real mass = 0;  ///< kg/m or kg
  Motion motion = Motion::driven;
  Rotation rotation = Rotation::fixed;
  Real inertia = 0;  ///< about its centre (in space: about z), kg m or kg m2
};

/// What changes of a rigid body.
template <int dim>
struct RigidState {
  Vec<dim> displacement = Vec<dim>::Zero();     ///< since the start, m
  Real angle = 0;                               ///< since the start, counter-clockwise about the centre (in space: about z), rad
  Vec<dim> velocity = Vec<dim>::Zero();         ///< of the centre, m/s, in force during the step
  Real angular_velocity = 0;                    ///< rad/s, in force during the step
  Vec<dim> reaction = Vec<dim>::Zero();         ///< force of the soil on it in the last step, N/m or N
  Vec<dim> smooth_reaction = Vec<dim>::Zero();  ///< the same, averaged over about a hundred steps
  Real torque = 0;                              ///< of the soil on it about its centre in the last step, N m/m or N m
  Vec<dim> impulse = Vec<dim>::Zero();          ///< what its contacts gave to the soil since the start (step 4), N s/m or N s
  Real torque_impulse = 0;                      ///< the same about the centre as it was at the time, N s or N m s
  Vec<dim> second_impulse = Vec<dim>::Zero();   ///< the same for the correction of step 8, which is no force
  Real impulse_sum = 0;                         ///< sum of the magnitudes of all nodal impulses since the start, N s/m or N s
  Real impulse_times_gap =
      0;  ///< the same, each times the distance of the node's nearest particle from the surface; over impulse_sum: the contact gap
  Real max_overlap = 0;  ///< m, how far a particle was inside the body since the last row of the history
  Vec<dim> near_cells_displacement =
      Vec<dim>::Constant(infinity);  ///< displacement at which the cells near it were listed last (contact/detect.hpp), m
  Real near_cells_angle = 0;         ///< and its angle
};

/// Where its centre is now (of a half-plane: its point).
template <int dim>
Vec<dim> center_now(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Its shape where it is now, moved and turned.
template <int dim>
RigidShape<dim> placed(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Its kinetic energy, J/m or J.
template <int dim>
Real kinetic_energy(const RigidBody<dim>& rigid, const RigidState<dim>& state)
{
  return 0.5 * (rigid.mass * state.velocity.squaredNorm() + rigid.inertia * state.angular_velocity * state.angular_velocity);
}

/// The velocity of its point that is at x now: velocity + angular velocity x (x - centre).
template <int dim>
Vec<dim> velocity_at(const RigidBody<dim>& rigid, const RigidState<dim>& state, const Vec<dim>& x)
{
  const Vec<dim> from = x - center_now(rigid, state);
  Vec<dim> v = state.velocity;
  v[0] -= state.angular_velocity * from[1];
  v[1] += state.angular_velocity * from[0];
  return v;
}

}  // namespace berm::bodies
