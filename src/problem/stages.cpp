// SPDX-License-Identifier: BSD-3-Clause
#include "problem/stages.hpp"

namespace berm::problem {
namespace {

/// What gravity and a drive did to a free rigid body when they and its contacts changed its motion, less the work that the contacts counted when
/// they gave their part to the soil: the kinetic energy of a free body is in the balance, so what passes between it and the soil is not from outside.
template <int dim>
Real work_of_outside(const bodies::RigidBody<dim>& body, const bodies::RigidState<dim>& before, const bodies::RigidState<dim>& after,
                     Real dt)
{
  const Vec<dim> impulse = body.mass * (after.velocity - before.velocity) - dt * after.reaction;
  const Real torque_impulse = body.inertia * (after.angular_velocity - before.angular_velocity) - dt * after.torque;
  return impulse.dot(after.velocity + before.velocity) / 2 + torque_impulse * (after.angular_velocity + before.angular_velocity) / 2 +
         dt * (after.reaction.dot(before.velocity) + after.torque * before.angular_velocity);
}

}  // namespace

template <int dim>
PipeMotion pipe_motion(const Model<dim>& model, const State<dim>& state, Index rigid)
{
  return {state.rigid_bodies[rigid].displacement[0],
          model.surface - lowest_level<dim>(placed<dim>(model.rigid_bodies[rigid], state.rigid_bodies[rigid]))};
}

template <int dim>
Real drag_direction(const Model<dim>& model, const State<dim>& state)
{
  const StageSettings& stage = model.stages[state.stage.index];
  return stage.kind == StageKind::drag && (stage.velocity ? *stage.velocity : *stage.force) < 0 ? -1 : 1;
}

template <int dim>
void begin_stage(const Model<dim>& model, State<dim>& state)
{
  StageState<dim>& now = state.stage;
  const StageSettings& stage = model.stages[now.index];
  const Index driven = model.driven[now.index];
  now.begin_time = state.time;
  for (Drive& drive : now.drive) drive = {};
  for (std::size_t k = 0; k < state.tractions.size(); ++k) {
    TractionState& traction = state.tractions[k];
    const Real to = model.tractions[k].acts[now.index] ? 1 : 0;
    if (to != traction.to) traction = {state.time, part_of_traction(model.tractions[k], traction, state.time), to};
  }
  if (driven == none) return;

  const bodies::RigidState<dim>& rigid = state.rigid_bodies[driven];
  now.begin_displacement = rigid.displacement;
  const auto by_velocity = [&](int d, Real v) { now.drive[d] = {false, rigid.velocity[d], v}; };
  const auto by_force = [&](int d, Real f) { now.drive[d] = {true, -rigid.smooth_reaction[d], f}; };
  for (int d = 0; d < dim; ++d) by_velocity(d, 0);
  if (stage.kind == StageKind::push) {
    if (stage.velocity)
      by_velocity(1, -*stage.velocity);
    else
      by_force(1, -*stage.force);
  } else {
    if (stage.velocity)
      by_velocity(0, *stage.velocity);
    else
      by_force(0, *stage.force);
    if (stage.vertical_velocity)
      by_velocity(1, -*stage.vertical_velocity);
    else if (stage.vertical == Vertical::hold)
      by_force(1, stage.vertical_force ? -*stage.vertical_force : -rigid.smooth_reaction[1]);
  }
}

template <int dim>
bool stage_ended(const Model<dim>& model, const State<dim>& state)
{
  const StageState<dim>& now = state.stage;
  const StageSettings& stage = model.stages[now.index];
  const Until& until = stage.until;
  // The slack is for the round-off in the sum of time steps.
  if (until.time && state.time - now.begin_time >= *until.time * (1 - 1e-12)) return true;
  const Index driven = model.driven[now.index];
  if (driven == none) return false;
  const bodies::RigidState<dim>& rigid = state.rigid_bodies[driven];
  if (until.displacement && std::abs(rigid.displacement[0] - now.begin_displacement[0]) >= *until.displacement) return true;
  if (until.embedment && pipe_motion(model, state, driven).w >= *until.embedment) return true;
  return until.force && resistance(model, state, rigid.smooth_reaction) >= *until.force;
}

template <int dim>
void drive_rigids(const Model<dim>& model, State<dim>& state, Real dt)
{
  const StageSettings& stage = model.stages[state.stage.index];
  const Real since = state.time + dt - state.stage.begin_time;
  const Vec<dim> gravity = gravity_now(model, state.time);
  for (Index r = 0; r < static_cast<Index>(state.rigid_bodies.size()); ++r) {
    const bodies::RigidBody<dim>& body = model.rigid_bodies[r];
    bodies::RigidState<dim>& rigid = state.rigid_bodies[r];
    const bodies::RigidState<dim> before = rigid;
    const bool driven = r == model.driven[state.stage.index];
    const bool moves = driven || (body.motion == bodies::Motion::free && stage.kind != StageKind::geostatic);
    for (int d = 0; d < dim; ++d) {
      const Drive& drive = state.stage.drive[d];
      const Real value = ramped(stage, drive, since);
      if (driven)
        rigid.velocity[d] = drive.by_force ? rigid.velocity[d] + dt * (value + rigid.reaction[d]) / body.mass : value;
      else
        rigid.velocity[d] = moves ? rigid.velocity[d] + dt * (gravity[d] + rigid.reaction[d] / body.mass) : 0;
    }
    rigid.angular_velocity =
        moves && body.rotation == bodies::Rotation::free ? rigid.angular_velocity + dt * rigid.torque / body.inertia : 0;
    if (body.motion == bodies::Motion::free) state.totals.external += work_of_outside(body, before, rigid, dt);
  }
}

Real expected_time(const StageSettings& stage)
{
  Real min = stage.until.time.value_or(infinity);
  if (stage.velocity && *stage.velocity != 0) {
    const Real speed = std::abs(*stage.velocity);
    if (stage.kind == StageKind::drag && stage.until.displacement) min = std::min(min, *stage.until.displacement / speed + stage.ramp / 2);
    if (stage.kind == StageKind::push && stage.until.embedment) min = std::min(min, *stage.until.embedment / speed + stage.ramp / 2);
  }
  // A body that starts above the bed may have a negative embedment to reach.
  return 0 < min && min < infinity ? min : 0;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template PipeMotion pipe_motion(const Model<dim>&, const State<dim>&, Index);                                                            \
  template Real drag_direction(const Model<dim>&, const State<dim>&);                                                                      \
  template void begin_stage(const Model<dim>&, State<dim>&);                                                                               \
  template bool stage_ended(const Model<dim>&, const State<dim>&);                                                                         \
  template void drive_rigids(const Model<dim>&, State<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
