// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/stages_test.cpp
#include "bodies/rigid/dynamics.hpp"

namespace berm::bodies {
namespace {

/// Increment of the angular velocity by a moment in a step.
Real angular_velocity_change(const RigidBody<2>& body, const RigidState<2>&, Real moment, Real dt)
{
  return dt * moment / body.inertia;
}
Vec<3> angular_velocity_change(const RigidBody<3>& body, const RigidState<3>& state, const Vec<3>& moment, Real dt)
{
  const Matrix<3> axes = state.orientation.matrix();
  const Vec<3> gyroscopic = cross(state.angular_velocity, times_inertia(body, state, state.angular_velocity));
  const Vec<3> local = axes.transpose() * (moment - gyroscopic);
  return axes * Vec<3>(dt * local.cwiseQuotient(body.inertia));
}

Real angular_of(const DriveNow<2>& drive)
{
  return drive.value[2];
}
Vec<3> angular_of(const DriveNow<3>& drive)
{
  return {drive.value[3], drive.value[4], drive.value[5]};
}

}  // namespace

template <int dim>
void drive_body(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, Real dt)
{
  for (int d = 0; d < dim; ++d)
    state.velocity[d] = drive.by_force[d] ? state.velocity[d] + dt * (drive.value[d] + state.reaction[d]) / body.mass : drive.value[d];
  const Angular<dim> prescribed = angular_of(drive);
  if constexpr (dim == 2) {
    state.angular_velocity =
        drive.by_force[2] ? state.angular_velocity + angular_velocity_change(body, state, prescribed + state.torque, dt) : prescribed;
  } else {
    Vec<3> moment = state.torque;
    for (int d = 0; d < 3; ++d) moment[d] += drive.by_force[3 + d] ? prescribed[d] : 0;
    const Vec<3> free = state.angular_velocity + angular_velocity_change(body, state, moment, dt);
    for (int d = 0; d < 3; ++d) state.angular_velocity[d] = drive.by_force[3 + d] ? free[d] : prescribed[d];
  }
}

template <int dim>
void free_body(const RigidBody<dim>& body, RigidState<dim>& state, const Vec<dim>& gravity, Real dt)
{
  for (int d = 0; d < dim; ++d) state.velocity[d] = state.velocity[d] + dt * (gravity[d] + state.reaction[d] / body.mass);
  if (body.rotation == Rotation::free)
    state.angular_velocity += angular_velocity_change(body, state, state.torque, dt);
  else
    state.angular_velocity = no_angular<dim>();
}

template <int dim>
void move_body(RigidState<dim>& state, Real dt)
{
  constexpr Real averaged_steps = 100;
  state.displacement += dt * state.velocity;
  state.orientation.turn_by(dt * state.angular_velocity);
  state.smooth_reaction += (state.reaction - state.smooth_reaction) / averaged_steps;
}

template <int dim>
Real work_of_outside(const RigidBody<dim>& body, const RigidState<dim>& before, const RigidState<dim>& after, Real dt)
{
  const Vec<dim> impulse = body.mass * (after.velocity - before.velocity) - dt * after.reaction;
  const Angular<dim> change = after.angular_velocity - before.angular_velocity;
  const Angular<dim> torque_impulse = times_inertia(body, before, change) - dt * after.torque;
  const Angular<dim> sum = after.angular_velocity + before.angular_velocity;
  return impulse.dot(after.velocity + before.velocity) / 2 + dot(torque_impulse, sum) / 2 +
         dt * (after.reaction.dot(before.velocity) + dot(after.torque, before.angular_velocity));
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void drive_body(const RigidBody<dim>&, RigidState<dim>&, const DriveNow<dim>&, Real);                                           \
  template void free_body(const RigidBody<dim>&, RigidState<dim>&, const Vec<dim>&, Real);                                                 \
  template void move_body(RigidState<dim>&, Real);                                                                                         \
  template Real work_of_outside(const RigidBody<dim>&, const RigidState<dim>&, const RigidState<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
