// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"

namespace berm::bodies {

/// Degrees of freedom of a rigid body: its displacements, then its rotation about z, in space those about x, y and z.
template <int dim>
constexpr int freedoms = dim == 2 ? 3 : 6;

/// A stage's drive of one degree of freedom: a velocity or a force (of a rotation: a moment), varying from one value to
/// another.
struct Drive {
  bool by_force = false;
  Real from = 0, to = 0;  ///< m/s or N/m (in space: N); of a rotation rad/s or N (in space: N m)
  Real spring = 0;        ///< stiffness of a spring besides a force, N/m2 (in space: N/m); of a rotation N/rad (in space: N m/rad)
};

/// The drives of one body at a time.
template <int dim>
struct DriveNow {
  bool by_force[freedoms<dim>];
  Real value[freedoms<dim>];
};

/// Velocity of a driven body in the next step; where a force drives it, by Newton's second law with the reaction of the last
/// step:
///
///   v = prescribed,  or  v + dt (force + reaction) / m;   omega = prescribed,  or  omega + dt (moment + torque) / I.
///
/// In space I turns with the body: the angular momentum I omega of the middle of the step, whose orientation omega makes, is that of the middle of the last step
/// plus dt (moment + torque). So it is kept to round-off where no moment acts and the step stays, and the energy has no drift.
///
/// `arm`, from its centre: where the velocities and forces along the axes act. There v + omega x arm is what is prescribed, by an impulse that also turns the body.
template <int dim>
void drive_body(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, Real dt,
                const Vec<dim>& arm = Vec<dim>::Zero());

/// The same for a body under gravity (m/s2) and contact alone.
template <int dim>
void free_body(const RigidBody<dim>& body, RigidState<dim>& state, const Vec<dim>& gravity, Real dt);

/// Adds an impulse (N s/m or N s) that acts at `arm` from its centre to the velocities of a body: of the freedoms that `drive` prescribes by no velocity.
template <int dim>
void add_impulse(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, const Vec<dim>& arm,
                 const Vec<dim>& impulse);

/// Takes the velocity of a body.
template <int dim>
void stop(RigidState<dim>& state)
{
  state.velocity.setZero();
  state.angular_velocity = no_angular<dim>();
}

/// Moves a body by its velocities over a step, and takes note of its reaction.
template <int dim>
void move_body(const RigidBody<dim>& body, RigidState<dim>& state, Real dt);

/// External work on a free rigid body: that of gravity and drives, less the work that its contacts have already counted. The
/// kinetic energy of a free body is part of the balance, so its exchange with the soil is internal.
template <int dim>
Real work_of_outside(const RigidBody<dim>& body, const RigidState<dim>& before, const RigidState<dim>& after, Real dt);

}  // namespace berm::bodies
