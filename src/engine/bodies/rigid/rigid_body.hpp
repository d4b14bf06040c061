// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_settings.hpp"
#include "bodies/rigid/rotation.hpp"

namespace berm::bodies {

/// A rigid body: shape at the start, mass, and how it may move.
template <int dim>
struct RigidBody {
  std::string name;
  RigidShape<dim> shape;
  Real mass = 0;  ///< kg/m or kg
  Motion motion = Motion::driven;
  Rotation rotation = Rotation::fixed;
  Angular<dim> inertia = no_angular<dim>();    ///< about its centre, kg m; in space about its axes, kg m2; may be infinite
  Matrix<dim> axes = Matrix<dim>::Identity();  ///< columns: the directions of these axes at the start
  Vec<dim> first_velocity = Vec<dim>::Zero();  ///< m/s, of a free body where its first stage that is not geostatic begins
};

/// Where a rigid body is: what it has moved since the start.
template <int dim>
struct Pose {
  Vec<dim> displacement = Vec<dim>::Zero();  ///< of the centre, m
  Orientation<dim> orientation;              ///< about the centre

  /// That of no body: infinitely far.
  static Pose nowhere() { return {Vec<dim>::Constant(infinity), {}}; }
  bool operator==(const Pose&) const = default;
};

/// How a rigid body moves, and what moves it.
template <int dim>
struct RigidState : Pose<dim> {
  Vec<dim> velocity = Vec<dim>::Zero();               ///< of the centre during the step, m/s
  Angular<dim> angular_velocity = no_angular<dim>();  ///< rad/s, during the step
  Vec<dim> reaction = Vec<dim>::Zero();               ///< force of the soil on it in the last step, N/m or N
  Vec<dim> smooth_reaction = Vec<dim>::Zero();        ///< the same, averaged over about a hundred steps
  Angular<dim> torque = no_angular<dim>();            ///< of the soil on it about its centre in the last step, N m/m or N m
};

/// The largest distance that a point of a rigid body goes from one pose to another, m: at most.
template <int dim>
Real distance_between(const RigidBody<dim>& rigid, const Pose<dim>& from, const Pose<dim>& to)
{
  return (to.displacement - from.displacement).norm() + angle_between(to.orientation, from.orientation) * reach_of<dim>(rigid.shape);
}

/// Its centre there (of a half-plane: its point).
template <int dim>
Vec<dim> center_now(const RigidBody<dim>& rigid, const Pose<dim>& pose);

/// Its shape there.
template <int dim>
RigidShape<dim> placed(const RigidBody<dim>& rigid, const Pose<dim>& pose);

/// Its angular momentum at an angular velocity, N s or N m s. In space: 0 about axes that it cannot rotate about.
inline Real times_inertia(const RigidBody<2>& rigid, const Pose<2>&, Real angular_velocity)
{
  return rigid.inertia * angular_velocity;
}
Vec<3> times_inertia(const RigidBody<3>& rigid, const Pose<3>& pose, const Vec<3>& angular_velocity);

/// The inverse of its moments of inertia at an orientation, 1/(kg m2); 0 about axes that it cannot rotate about.
Matrix<3> inverse_inertia(const RigidBody<3>& rigid, const Orientation<3>& orientation);

/// Its kinetic energy, J/m or J.
template <int dim>
Real kinetic_energy(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Velocity of its point that is now at x: velocity + angular velocity x (x - centre).
template <int dim>
Vec<dim> velocity_at(const RigidBody<dim>& rigid, const RigidState<dim>& state, const Vec<dim>& x)
{
  const Vec<dim> from = x - center_now(rigid, state);
  Vec<dim> v = state.velocity;
  if constexpr (dim == 2) {
    v[0] -= state.angular_velocity * from[1];
    v[1] += state.angular_velocity * from[0];
  } else {
    v += cross(state.angular_velocity, from);
  }
  return v;
}

}  // namespace berm::bodies
