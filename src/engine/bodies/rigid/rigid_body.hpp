// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_settings.hpp"
#include "bodies/rigid/rotation.hpp"

namespace berm::bodies {

/// How what the soil did to a rigid body fades: to 1/e over a travel, and over a time where it hardly moves.
struct Fading {
  Real travel = infinity;  ///< m
  Real time = 0;           ///< s; 0: at once

  /// The part that a step of dt (s), in which the body goes `step_way` of its `way` since it touched (m), has in a mean. That fades over a quarter of the way at most:
  /// what was before says nothing.
  Real fraction_of_step(Real step_way, Real way, Real dt) const;
};

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
  Fading fading = {};                          ///< of RigidState::recent
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

/// What the soil lately did to a rigid body: fading means, and how they went with the way that the body has gone (a discounted linear regression; Brown 1963), so that what it does now is known
/// without the noise of single steps and without lag.
template <int dim>
struct RecentReaction {
  Real way = 0;                                  ///< m, since the body touched for the first time
  Real lag = 0;                                  ///< m, by which the way is ahead of its mean
  Real variance = 0;                             ///< m2, of the way
  Vec<dim> mean_force = Vec<dim>::Zero();        ///< N/m or N
  Vec<dim> force_covariance = Vec<dim>::Zero();  ///< with the way
  Angular<dim> mean_torque = no_angular<dim>();  ///< N m/m or N m
  Angular<dim> torque_covariance = no_angular<dim>();

  /// Of a soil that has long done this.
  static RecentReaction steady(const Vec<dim>& force, const Angular<dim>& torque)
  {
    RecentReaction recent;
    recent.mean_force = force;
    recent.mean_torque = torque;
    return recent;
  }
  Vec<dim> force() const { return mean_force + ahead() * force_covariance; }
  Angular<dim> torque() const { return mean_torque + ahead() * torque_covariance; }
  /// Adds a step of dt (s) in which the body's surface went `step_way` (m) at most.
  void add(const Vec<dim>& force, const Angular<dim>& torque, Real step_way, Real dt, const Fading& fading);

private:
  Real ahead() const { return variance > 0 ? lag / variance : 0; }
};

/// How a rigid body moves, and what moves it.
template <int dim>
struct RigidState : Pose<dim> {
  Vec<dim> velocity = Vec<dim>::Zero();               ///< of the centre during the step, m/s
  Angular<dim> angular_velocity = no_angular<dim>();  ///< rad/s, during the step
  Vec<dim> reaction = Vec<dim>::Zero();               ///< force of the soil on it in the last step, N/m or N
  Angular<dim> torque = no_angular<dim>();            ///< of the soil on it about its centre in the last step, N m/m or N m
  RecentReaction<dim> recent;                         ///< reaction and torque as they lately were
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
