// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/stages_test.cpp
#include "bodies/rigid/dynamics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace berm::bodies {
namespace {

/// The angular momentum halfway through a step with the present angular velocity that begins (sign 1) or has just ended (-1).
Vec<3> momentum_halfway(const RigidBody<3>& body, const RigidState<3>& state, Real dt, Real sign)
{
  Pose<3> halfway = state;
  halfway.orientation.turn_by(sign * dt / 2 * state.angular_velocity);
  return times_inertia(body, halfway, state.angular_velocity);
}

/// Sets the angular velocity in the coming step by a moment; about the axes that the drive prescribes it is that of the drive.
void rotate(const RigidBody<2>& body, RigidState<2>& state, Real moment, const DriveNow<2>* drive, Real dt)
{
  state.angular_velocity = drive != nullptr && !drive->by_force[2] ? drive->value[2] : state.angular_velocity + dt * moment / body.inertia;
}
void rotate(const RigidBody<3>& body, RigidState<3>& state, const Vec<3>& moment, const DriveNow<3>* drive, Real dt)
{
  // The angular momentum changes by the moment, and by what holds the driven axes. It belongs to the middle of the step, whose orientation the angular
  // velocity makes: some substitutions, each of which takes dt times it from the error.
  constexpr int substitutions = 8;
  constexpr Real round_off = 1e-15;
  const Vec<3> momentum = momentum_halfway(body, state, dt, -1) + dt * moment;
  Vec<3> given = Vec<3>::Zero(), is_given = Vec<3>::Zero();
  for (int d = 0; d < 3; ++d)
    if (drive != nullptr && !drive->by_force[3 + d]) given[d] = drive->value[3 + d], is_given[d] = 1;
  Vec<3> omega = is_given.minCoeff() > 0 ? given : state.angular_velocity;
  for (int k = 0; k < substitutions && is_given.minCoeff() == 0; ++k) {
    Orientation<3> halfway = state.orientation;
    halfway.turn_by(dt / 2 * omega);
    const Matrix<3> inverse = inverse_inertia(body, halfway);
    Vec<3> next = inverse * momentum;
    // The moments of what drives: they are about the driven axes and give them their angular velocity; zero about the others, of which the matrix has nothing.
    Matrix<3> driven = is_given.asDiagonal() * inverse * is_given.asDiagonal();
    const Vec<3> holding = driven.ldlt().solve(Vec<3>(is_given.cwiseProduct(given - next)));
    next += inverse * is_given.cwiseProduct(holding);
    for (int d = 0; d < 3; ++d)
      if (is_given[d] != 0) next[d] = given[d];
    const Real change = (next - omega).norm();
    omega = next;
    if (change <= round_off * omega.norm()) break;
  }
  state.angular_velocity = omega;
}

template <int dim>
Angular<dim> moment_on(const RigidState<dim>& state, const DriveNow<dim>& drive)
{
  Angular<dim> moment = state.torque;
  if constexpr (dim == 2) {
    moment = drive.value[2] + moment;
  } else {
    for (int d = 0; d < 3; ++d) moment[d] += drive.by_force[3 + d] ? drive.value[3 + d] : 0;
  }
  return moment;
}

/// The angular velocity that a moment of impulse gives about the axes that no drive prescribes.
Real turned_by(const RigidBody<2>& body, const RigidState<2>&, Real impulse, const DriveNow<2>& drive)
{
  return drive.by_force[2] ? impulse / body.inertia : 0;
}
Vec<3> turned_by(const RigidBody<3>& body, const RigidState<3>& state, const Vec<3>& impulse, const DriveNow<3>& drive)
{
  Vec<3> is_given = Vec<3>::Zero();
  for (int d = 0; d < 3; ++d) is_given[d] = drive.by_force[3 + d] ? 0 : 1;
  if (is_given.minCoeff() > 0) return Vec<3>::Zero();
  const Matrix<3> inverse = inverse_inertia(body, state.orientation);
  Vec<3> turn = inverse * impulse;
  const Matrix<3> driven = is_given.asDiagonal() * inverse * is_given.asDiagonal();
  const Vec<3> holding = driven.ldlt().solve(Vec<3>(is_given.cwiseProduct(-turn)));
  turn += inverse * is_given.cwiseProduct(holding);
  for (int d = 0; d < 3; ++d)
    if (is_given[d] != 0) turn[d] = 0;
  return turn;
}

/// Drives the body at a point off its centre: first as if the velocities there were free, then an impulse J at the point makes them what they shall be,
/// K J = v_prescribed - (v + omega x arm) with K_ij = delta_ij/m + ((I^-1 (arm x e_j)) x arm)_i.
template <int dim>
void drive_at_point(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, const Vec<dim>& arm, Real dt)
{
  Vec<dim> force = Vec<dim>::Zero();
  for (int d = 0; d < dim; ++d) force[d] = drive.by_force[d] ? drive.value[d] : 0;
  state.velocity += dt / body.mass * (force + state.reaction);
  rotate(body, state, Angular<dim>(moment_on<dim>(state, drive) + moment_of(arm, force)), &drive, dt);
  Matrix<dim> K = Matrix<dim>::Identity();
  Vec<dim> missing = Vec<dim>::Zero();
  const Vec<dim> there = state.velocity + cross(state.angular_velocity, arm);
  for (int j = 0; j < dim; ++j) {
    if (drive.by_force[j]) continue;
    missing[j] = drive.value[j] - there[j];
    Vec<dim> unit = Vec<dim>::Zero();
    unit[j] = 1;
    const Vec<dim> moved = unit / body.mass + cross(turned_by(body, state, moment_of(arm, unit), drive), arm);
    for (int i = 0; i < dim; ++i) K(i, j) = drive.by_force[i] ? 0 : moved[i];
  }
  const Vec<dim> impulse = K.ldlt().solve(missing);
  state.velocity += impulse / body.mass;
  state.angular_velocity += turned_by(body, state, moment_of(arm, impulse), drive);
}

}  // namespace

template <int dim>
void drive_body(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, Real dt, const Vec<dim>& arm)
{
  if (!arm.isZero(0)) return drive_at_point(body, state, drive, arm, dt);
  for (int d = 0; d < dim; ++d)
    state.velocity[d] = drive.by_force[d] ? state.velocity[d] + dt * (drive.value[d] + state.reaction[d]) / body.mass : drive.value[d];
  rotate(body, state, moment_on<dim>(state, drive), &drive, dt);
}

template <int dim>
void add_impulse(const RigidBody<dim>& body, RigidState<dim>& state, const DriveNow<dim>& drive, const Vec<dim>& arm,
                 const Vec<dim>& impulse)
{
  for (int d = 0; d < dim; ++d)
    if (drive.by_force[d]) state.velocity[d] += impulse[d] / body.mass;
  state.angular_velocity += turned_by(body, state, moment_of(arm, impulse), drive);
}

template <int dim>
void free_body(const RigidBody<dim>& body, RigidState<dim>& state, const Vec<dim>& gravity, Real dt)
{
  for (int d = 0; d < dim; ++d) state.velocity[d] = state.velocity[d] + dt * (gravity[d] + state.reaction[d] / body.mass);
  if (body.rotation == Rotation::free)
    rotate(body, state, state.torque, nullptr, dt);
  else
    state.angular_velocity = no_angular<dim>();
}

Real Fading::fraction_of_step(Real step_way, Real way, Real dt) const
{
  constexpr Real fraction_of_way = 0.25;
  return 1 - 1 / (1 + dt / time + (step_way > 0 ? step_way / std::min(travel, fraction_of_way * way) : 0));
}

template <int dim>
void RecentReaction<dim>::add(const Vec<dim>& force, const Angular<dim>& torque, Real step_way, Real dt, const Fading& fading)
{
  const bool has_touched = way > 0 || !force.isZero(0);
  way = has_touched ? way + step_way : 0;
  const Real fraction = has_touched ? fading.fraction_of_step(step_way, way, dt) : 1;
  lag += step_way;
  variance = (1 - fraction) * (variance + fraction * lag * lag);
  force_covariance = (1 - fraction) * (force_covariance + fraction * lag * (force - mean_force));
  torque_covariance = (1 - fraction) * (torque_covariance + fraction * lag * (torque - mean_torque));
  mean_force += fraction * (force - mean_force);
  mean_torque += fraction * (torque - mean_torque);
  lag *= 1 - fraction;
}

template <int dim>
void move_body(const RigidBody<dim>& body, RigidState<dim>& state, Real dt)
{
  state.displacement += dt * state.velocity;
  state.orientation.turn_by(dt * state.angular_velocity);
  const Real speed = state.velocity.norm() + size_of_angular(state.angular_velocity) * reach_of<dim>(body.shape);
  state.recent.add(state.reaction, state.torque, dt * speed, dt, body.fading);
}

template <int dim>
Real work_of_outside(const RigidBody<dim>& body, const RigidState<dim>& before, const RigidState<dim>& after, Real dt)
{
  const Vec<dim> impulse = body.mass * (after.velocity - before.velocity) - dt * after.reaction;
  Angular<dim> torque_impulse = no_angular<dim>();
  if constexpr (dim == 2)
    torque_impulse = times_inertia(body, before, after.angular_velocity - before.angular_velocity) - dt * after.torque;
  else
    torque_impulse = momentum_halfway(body, after, dt, 1) - momentum_halfway(body, before, dt, -1) - dt * after.torque;
  const Angular<dim> sum = after.angular_velocity + before.angular_velocity;
  return impulse.dot(after.velocity + before.velocity) / 2 + dot(torque_impulse, sum) / 2 +
         dt * (after.reaction.dot(before.velocity) + dot(after.torque, before.angular_velocity));
}

template struct RecentReaction<2>;
template struct RecentReaction<3>;
#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void drive_body(const RigidBody<dim>&, RigidState<dim>&, const DriveNow<dim>&, Real, const Vec<dim>&);                          \
  template void add_impulse(const RigidBody<dim>&, RigidState<dim>&, const DriveNow<dim>&, const Vec<dim>&, const Vec<dim>&);              \
  template void free_body(const RigidBody<dim>&, RigidState<dim>&, const Vec<dim>&, Real);                                                 \
  template void move_body(const RigidBody<dim>&, RigidState<dim>&, Real);                                                                  \
  template Real work_of_outside(const RigidBody<dim>&, const RigidState<dim>&, const RigidState<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
