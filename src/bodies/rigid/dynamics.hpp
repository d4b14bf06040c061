// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"

namespace berm::bodies {

/// Degrees of freedom of a rigid body: its displacements, then its rotation about z, in space those about x, y and z.
template <int dim>
constexpr int freedoms = dim == 2 ? 3 : 6;

/// What a stage does with one degree of freedom: a velocity or a force (of a rotation: a moment) goes from one value to another.
struct Drive {
  bool by_force = false;
  Real from = 0, to = 0;  ///< m/s or N/m (in space: N); of a rotation rad/s or N (in space: N m)
};

/// The drives of one body at a moment.
template <int dim>
struct DriveNow {
  bool by_force[freedoms<dim>];
  Real value[freedoms<dim>];
};

/// The velocity of a driven body in the coming step, by the second law with the reaction of the last step where a force drives it:
///
///   v = given,  or  v + dt (force + reaction) / m;   omega = given,  or  omega + dt I^-1 (moment + torque - omega x I omega).
template <int dim>
void drive_body(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, Real dt);

/// The same of a body that only gravity (m/s2) and its contacts move.
template <int dim>
void free_body(const RigidBody<dim>& body, RigidState<dim>& state, const Vec<dim>& gravity, Real dt);

template <int dim>
void rest(RigidState<dim>& state)
{
  state.velocity.setZero();
  state.angular_velocity = no_angular<dim>();
}

/// Moves a body by its velocities over a step, and averages its reaction.
template <int dim>
void move_body(RigidState<dim>& state, Real dt);

/// What gravity and a drive did to a free rigid body when they and its contacts changed its motion, less the work that the contacts counted when they
/// gave their part to the soil: the kinetic energy of a free body is in the balance, so what passes between it and the soil is not from outside.
template <int dim>
Real work_of_outside(const RigidBody<dim>& body, const RigidState<dim>& before, const RigidState<dim>& after, Real dt);

}  // namespace berm::bodies
