// SPDX-License-Identifier: BSD-3-Clause
#include "problem/stages.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::problem {

template <int dim>
RigidTravel travel_of(const Model<dim>& model, const State<dim>& state, Index rigid)
{
  const Axes<dim>& axes = model.axes;
  const bodies::RigidState<dim>& body = state.rigid_bodies[rigid];
  const bodies::RigidBody<dim>& shape = model.rigid_bodies[rigid];
  const Real surface = model.surface_at(center_now<dim>(shape, body));
  return {body.displacement[axes.along], axes.sign * surface - lowest_level<dim>(placed<dim>(shape, body), axes.up_vector())};
}

namespace {

/// What a limit of displacement counts: the distance of a drive, the way of a drag along its velocity, and to either side of one that a force or a load history
/// moves.
template <int dim>
Real travel_in(const settings::StageSettings& stage, const Vec<dim>& moved, int along)
{
  if (stage.kind == settings::StageKind::drive) return moved.norm();
  return stage.velocity && stage.load_times.empty() ? std::copysign(Real(1), *stage.velocity) * moved[along] : std::abs(moved[along]);
}

/// The column of displacements (of load_columns) that drives a freedom; none where no one does.
template <int dim>
int displacement_column_of(const settings::StageSettings& stage, const Axes<dim>& axes, int freedom)
{
  const int column = load_column_of(stage, axes, freedom);
  return column != none && settings::load_columns[static_cast<std::size_t>(column)].quantity == settings::LoadQuantity::displacement
             ? column
             : none;
}

/// From the centre of the driven body to where the stage drives it along the axes, at an orientation of the body, m.
template <int dim>
Vec<dim> arm_of(const settings::StageSettings& stage, const bodies::RigidBody<dim>& body, const bodies::Orientation<dim>& orientation)
{
  if (stage.drive.point.empty()) return Vec<dim>::Zero();
  return orientation.matrix() * (bodies::to_vec<dim>(stage.drive.point) - center_of<dim>(body.shape));
}

/// How far the point where the stage drives its body went since the stage began, m.
template <int dim>
Vec<dim> moved_of_point(const settings::StageSettings& stage, const StageState<dim>& now, const bodies::RigidBody<dim>& body,
                        const bodies::RigidState<dim>& rigid)
{
  return rigid.displacement - now.begin_displacement + arm_of<dim>(stage, body, rigid.orientation) -
         arm_of<dim>(stage, body, now.begin_orientation);
}

/// Gives the particles back what the stage says of the strength that remoulding took.
template <int dim>
void recover_strength(const Model<dim>& model, Real share, std::vector<bodies::Particles<dim>>& bodies)
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    bodies[b].visit([&](Index, Index block, int lane) {
      bodies::Particle<dim> p = bodies[b].read(block, lane);
      recover(material_of(model.bodies[b].soil, p.extra), share, p.extra);
      for (int k = 0; k < bodies[b].extra_size(); ++k) bodies[b].extra(block)[k][lane] = p.extra[k];
    });
}

/// The first stage that is not geostatic.
Index first_moving_stage(const std::vector<settings::StageSettings>& stages)
{
  const auto moves = [](const settings::StageSettings& stage) { return stage.kind != settings::StageKind::geostatic; };
  return static_cast<Index>(std::find_if(stages.begin(), stages.end(), moves) - stages.begin());
}

/// Gives free bodies the velocities that they begin with. What throws them does work from outside.
template <int dim>
void throw_bodies(const Model<dim>& model, State<dim>& state)
{
  for (Index r = 0; r < static_cast<Index>(state.rigid_bodies.size()); ++r) {
    const bodies::RigidBody<dim>& body = model.rigid_bodies[r];
    if (body.first_velocity.isZero(0)) continue;
    state.rigid_bodies[r].velocity = body.first_velocity;
    state.ledger.totals.external += body.mass * body.first_velocity.squaredNorm() / 2;
  }
}

/// Windows begin with the stage; a pressure without waves goes on.
template <int dim>
void begin_pressure_means(const Model<dim>& model, State<dim>& state)
{
  PressureMeans& means = state.stage.pressure_means;
  means = {};
  means.begin = state.time;
  for (CellField<Real>& sums : state.pressure_sums) sums.assign(sums.size(), 0);
  if (!(model.pressure_window > 0)) note_without_waves(means, state.stage.excess_pressure);
}

/// What the soil does to a body after a stage that drove it: where its mean came to the stage's limit of force, that mean.
template <int dim>
Vec<dim> reaction_after(const Model<dim>& model, const settings::StageSettings& stage, const ForceApproach& approach,
                        const bodies::RecentReaction<dim>& recent)
{
  Vec<dim> reaction = recent.force();
  if (!stage.until.force || !stage.velocity || !stage.load_times.empty()) return reaction;
  const Vec<dim> along = resisting(model, stage);
  const Real mean = along.dot(recent.mean_force), way = *stage.until.force - approach.begin;
  if ((mean - approach.begin) * way >= way * way) reaction += (mean - along.dot(reaction)) * along;
  return reaction;
}

}  // namespace

template <int dim>
Real load_of_water(const Model<dim>& model, const State<dim>& state, const settings::StageSettings& stage, int freedom, Real since)
{
  const Index driven = model.driven[state.stage.index];
  const settings::WaterForce force = water_force(*stage.water, water_at(stage, since), width_of<dim>(model.rigid_bodies[driven].shape),
                                                 state.rigid_bodies[driven].velocity[model.axes.along], travel_of(model, state, driven).w);
  return freedom == model.axes.along ? force.H : force.V;
}

template <int dim>
void begin_stage(const Model<dim>& model, State<dim>& state)
{
  StageState<dim>& now = state.stage;
  const settings::StageSettings& stage = model.stages[now.index];
  if (stage.strength_recovery > 0) recover_strength(model, stage.strength_recovery, state.particles);
  const Index driven = model.driven[now.index];
  const auto before = std::to_array(now.drive);
  const Real since = state.time - now.begin_time;
  now.begin_time = state.time;
  begin_pressure_means(model, state);
  for (bodies::Drive& drive : now.drive) drive = {};
  if (now.index == first_moving_stage(model.stages)) throw_bodies(model, state);
  const auto turn = [&](const auto& load, TractionState& turned) {
    const Real to = load.acts[now.index] ? 1 : 0;
    if (to != turned.to) turned = {state.time, acting_fraction(load, turned, state.time), to};
  };
  for (std::size_t k = 0; k < state.tractions.size(); ++k) turn(model.tractions[k], state.tractions[k]);
  boundary::for_each_of<boundary::Head<dim>>(model.conditions,
                                             [&](std::size_t k, const auto& row, const auto&) { turn(row, state.heads[k]); });
  if (driven == none) return;

  const bodies::RigidState<dim>& rigid = state.rigid_bodies[driven];
  now.begin_displacement = rigid.displacement;
  now.begin_orientation = rigid.orientation;
  const settings::StageDrives<dim> drives = drives_of(stage, model.axes, model.rigid_bodies[driven].rotation == bodies::Rotation::free);
  const Vec<dim> there =
      rigid.velocity + bodies::cross(rigid.angular_velocity, arm_of<dim>(stage, model.rigid_bodies[driven], rigid.orientation));
  const auto velocity = [&](int f) -> Real {
    if (f < dim) return there[f];
    if constexpr (dim == 2)
      return rigid.angular_velocity;
    else
      return rigid.angular_velocity[f - dim];
  };
  const bool same_body = now.index > 0 && model.driven[now.index - 1] == driven;
  const Vec<dim> reaction =
      same_body ? reaction_after(model, model.stages[now.index - 1], now.approach, rigid.recent) : rigid.recent.force();
  now.approach = {resistance(model, state, rigid.recent.mean_force)};
  const bodies::Angular<dim> torque = rigid.recent.torque();
  const auto balance = [&](int f) -> Real {
    if (f < dim) return -reaction[f];
    if constexpr (dim == 2)
      return -torque;
    else
      return -torque[f - dim];
  };
  const auto present_force = [&](int f) {
    return same_body && f < dim && before[f].by_force ? drive_now(model, state, model.stages[now.index - 1], before[f], f, since)
                                                      : balance(f);
  };
  for (int f = 0; f < bodies::freedoms<dim>; ++f) {
    const settings::FreedomDrive& drive = drives[f];
    switch (drive.by) {
    case settings::FreedomDrive::By::velocity:
      now.drive[f] = {false, drive.named ? velocity(f) : 0, drive.value};
      break;
    case settings::FreedomDrive::By::force:
      now.drive[f] = {true, present_force(f), drive.value};
      break;
    case settings::FreedomDrive::By::hold:
      now.drive[f] = {true, present_force(f), present_force(f)};
      break;
    case settings::FreedomDrive::By::free:
      now.drive[f] = {true, 0, 0};
      break;
    }
    now.drive[f].spring = drive.spring;
  }
}

namespace {

Real least_inertia(Real inertia)
{
  return inertia;
}
Real least_inertia(const Vec<3>& inertia)
{
  return inertia.minCoeff();
}

}  // namespace

template <int dim>
void drive_otherwise(const Model<dim>& model, State<dim>& state, int freedom, bool by_force, Real value)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const auto refuse = [&](const char* why) { throw InputError(fmt::format("the stage \"{}\" {}", stage.name, why)); };
  if (stage.kind != settings::StageKind::drive && stage.kind != settings::StageKind::pipeline)
    refuse("is not of kind = \"drive\", so its body cannot be driven from outside");
  if (stage.kind == settings::StageKind::drive && has_load_history(stage)) refuse("has a load history, which drives its body");
  if (!std::isfinite(value)) refuse("cannot drive its body by a number that is not finite");
  bodies::Drive& drive = state.stage.drive[freedom];
  if (drive.spring > 0) refuse("has a spring in this degree of freedom");
  const bodies::RigidBody<dim>& body = model.rigid_bodies[model.driven[state.stage.index]];
  const bool turns = freedom >= dim;
  if (by_force && !turns && !(body.mass > 0)) refuse("drives a body without a mass, which no force can move");
  if (by_force && turns && !(least_inertia(body.inertia) > 0))
    refuse("drives a body without a moment of inertia, which no moment can rotate");
  if (turns && !is_bounded(body.shape)) refuse("drives a half-plane, which cannot rotate");
  drive = {by_force, value, value, 0};
}

template <int dim>
bool lifts(const Model<dim>& model, const State<dim>& state)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const bodies::Drive& vertical = state.stage.drive[model.axes.up];
  if (model.driven[state.stage.index] == none || !stage.load_times.empty()) return false;
  if (!vertical.by_force) return model.axes.sign * vertical.to > 0;
  return stage.kind != settings::StageKind::drag && model.axes.sign * vertical.to > model.axes.sign * vertical.from;
}

template <int dim>
bool force_reached(const Model<dim>& model, const State<dim>& state, Real resistance)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  if (!stage.until.force) return false;
  return stage.kind == settings::StageKind::push && lifts(model, state) ? resistance <= *stage.until.force
                                                                        : resistance >= *stage.until.force;
}

template <int dim>
Real beyond_force_limit(const Model<dim>& model, const State<dim>& state)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const Index driven = model.driven[state.stage.index];
  if (driven == none || !stage.velocity || !stage.load_times.empty()) return nan;
  const Real mean = mean_resistance(model, state);
  if (!force_reached(model, state, mean)) return nan;
  return std::abs(state.stage.approach.now(mean) / *stage.until.force - 1);
}

template <int dim>
bool stage_ended(const Model<dim>& model, const State<dim>& state)
{
  const StageState<dim>& now = state.stage;
  const settings::StageSettings& stage = model.stages[now.index];
  const settings::Until& until = stage.until;
  // The slack is for the round-off in the sum of time steps.
  if (until.time && state.time - now.begin_time >= *until.time * (1 - 1e-12)) return true;
  if (until.consolidation && degree_of_consolidation(now) >= *until.consolidation) return true;
  const Index driven = model.driven[now.index];
  if (driven == none) return false;
  const bodies::RigidState<dim>& rigid = state.rigid_bodies[driven];
  const bodies::RigidBody<dim>& body = model.rigid_bodies[driven];
  const Vec<dim> moved = moved_of_point(stage, now, body, rigid);
  if (until.displacement && travel_in(stage, moved, model.axes.along) >= *until.displacement) return true;
  if (until.embedment) {
    const Real w = travel_of(model, state, driven).w;
    if (lifts(model, state) ? w <= *until.embedment : w >= *until.embedment) return true;
  }
  return force_reached(model, state, mean_resistance(model, state));
}

namespace {

/// How far a freedom of the driven body went since the stage began, m or rad.
template <int dim>
Real moved_in_stage(const StageState<dim>& stage, const bodies::RigidState<dim>& rigid, int f)
{
  if (f < dim) return rigid.displacement[f] - stage.begin_displacement[f];
  const bodies::Angular<dim> rotation = rotation_between(stage.begin_orientation, rigid.orientation);
  if constexpr (dim == 2)
    return rotation;
  else
    return rotation[f - dim];
}

/// The velocity in a coming step that brings a freedom at its end to where a column of displacements has it then: what is left of the way, over the step. In space
/// an angle is the integral of the angular velocity about its axis, of which the step takes its part.
template <int dim>
Real velocity_to(const settings::StageSettings& stage, const StageState<dim>& now, const bodies::RigidBody<dim>& body,
                 const bodies::RigidState<dim>& rigid, int f, int column, Real since, Real dt)
{
  const auto there = [&](Real time) { return now.drive[f].to * load_of_column(stage, static_cast<std::size_t>(column), time); };
  if (f < dim) return (there(since) - moved_of_point(stage, now, body, rigid)[f]) / dt;
  return (there(since) - (dim == 2 ? moved_in_stage(now, rigid, f) : there(since - dt))) / dt;
}

}  // namespace

template <int dim>
Real velocity_factor(const Model<dim>& model, const State<dim>& state, Real velocity)
{
  constexpr Real times = 2, beyond = 0.01, felt = 0.005;
  const settings::StageSettings& stage = model.stages[state.stage.index];
  if (!stage.until.force || !stage.velocity || !stage.load_times.empty()) return 1;
  const bodies::RigidBody<dim>& body = model.rigid_bodies[model.driven[state.stage.index]];
  const Real mean = mean_resistance(model, state), now = state.stage.approach.now(mean);
  const Real limit = *stage.until.force, direction = limit < state.stage.approach.begin ? -1 : 1;
  if (direction * (now - state.stage.approach.begin) < felt * std::abs(limit - state.stage.approach.begin)) return 1;
  const Real growth = state.stage.approach.stiffness(mean) * std::abs(velocity) * body.fading.time;
  const Real left = std::max(direction * (limit - now), Real(0)) + beyond * std::abs(limit);
  return left < times * growth ? left / (times * growth) : 1;
}

namespace {

/// Counts the travel of a coming step of dt (s) from where the resistance has begun to go to its limit.
template <int dim>
void count_approach(const Model<dim>& model, State<dim>& state, Real step, Real dt)
{
  constexpr Real begun = 1e-4;  // of its way
  ForceApproach& approach = state.stage.approach;
  const Real limit = *model.stages[state.stage.index].until.force;
  const Index driven = model.driven[state.stage.index];
  const bodies::RecentReaction<dim>& recent = state.rigid_bodies[driven].recent;
  const Real mean = mean_resistance(model, state);
  if ((mean - approach.begin) * (limit - approach.begin) < begun * (limit - approach.begin) * (limit - approach.begin))
    approach.travel = approach.mean_travel = 0;
  approach.travel += std::abs(step);
  approach.mean_travel += model.rigid_bodies[driven].fading.fraction_of_step(std::abs(step), recent.way + std::abs(step), dt) *
                          (approach.travel - approach.mean_travel);
}

}  // namespace

template <int dim>
void drive_rigids(const Model<dim>& model, State<dim>& state, Real dt)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const Real since = state.time + dt - state.stage.begin_time;
  const Vec<dim> gravity = gravity_now(model, state.time);
  const RigidVelocities<dim> last = velocities_at_contacts(model, state);
  for (Index r = 0; r < static_cast<Index>(state.rigid_bodies.size()); ++r) {
    const bodies::RigidBody<dim>& body = model.rigid_bodies[r];
    bodies::RigidState<dim>& rigid = state.rigid_bodies[r];
    const bodies::RigidState<dim> before = rigid;
    if (r == model.driven[state.stage.index]) {
      bodies::DriveNow<dim> now;
      for (int f = 0; f < bodies::freedoms<dim>; ++f) {
        now.by_force[f] = state.stage.drive[f].by_force;
        const int displacement = displacement_column_of(stage, model.axes, f);
        now.value[f] = displacement == none ? drive_now(model, state, stage, state.stage.drive[f], f, since)
                                            : velocity_to(stage, state.stage, body, rigid, f, displacement, since, dt);
        if (stage.until.force && !now.by_force[f] && f == main_freedom(model, stage)) {
          now.value[f] *= velocity_factor(model, state, now.value[f]);
          count_approach(model, state, dt * now.value[f], dt);
        }
        if (const Real stiffness = state.stage.drive[f].spring; stiffness > 0)
          now.value[f] -= stiffness * moved_in_stage(state.stage, rigid, f);
      }
      drive_body(body, rigid, now, dt, arm_of<dim>(stage, body, rigid.orientation));
    } else if (body.motion == bodies::Motion::free && stage.kind != settings::StageKind::geostatic) {
      free_body(body, rigid, gravity, dt);
    } else {
      stop(rigid);
    }
    if (body.motion == bodies::Motion::free) state.ledger.totals.external += work_of_outside(body, before, rigid, dt);
  }
  if (!model.rigid_contacts.empty()) push_apart(model, state, last, dt);
}

template <int dim>
void move_rigids(const Model<dim>& model, State<dim>& state)
{
  for (std::size_t r = 0; r < state.rigid_bodies.size(); ++r) move_body(model.rigid_bodies[r], state.rigid_bodies[r], state.dt);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template RigidTravel travel_of(const Model<dim>&, const State<dim>&, Index);                                                             \
  template Real load_of_water(const Model<dim>&, const State<dim>&, const settings::StageSettings&, int, Real);                            \
  template void drive_otherwise(const Model<dim>&, State<dim>&, int, bool, Real);                                                          \
  template bool lifts(const Model<dim>&, const State<dim>&);                                                                               \
  template bool force_reached(const Model<dim>&, const State<dim>&, Real);                                                                 \
  template Real beyond_force_limit(const Model<dim>&, const State<dim>&);                                                                  \
  template Real velocity_factor(const Model<dim>&, const State<dim>&, Real);                                                               \
  template void begin_stage(const Model<dim>&, State<dim>&);                                                                               \
  template bool stage_ended(const Model<dim>&, const State<dim>&);                                                                         \
  template void move_rigids(const Model<dim>&, State<dim>&);                                                                               \
  template void drive_rigids(const Model<dim>&, State<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
