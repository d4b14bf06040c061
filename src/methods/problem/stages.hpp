// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary/gravity.hpp"
#include "problem/model.hpp"
#include "settings/drives.hpp"

namespace berm::problem {

/// Where a rigid body is, along and against gravity, m.
struct RigidTravel {
  Real u = 0;  ///< horizontal displacement (Axes::along)
  Real w = 0;  ///< depth of the lowest point below the bed's first surface
};
template <int dim>
RigidTravel travel_of(const Model<dim>& model, const State<dim>& state, Index rigid);

/// +1, or -1 in a drag along -x, of the present stage.
template <int dim>
Real drag_direction(const Model<dim>& model, const State<dim>& state)
{
  return drag_direction(model.stages[state.stage.index]);
}

/// The unit vector along which the soil's force on the driven body is what a stage's limit of force is compared with: V in a push, H in a drag.
template <int dim>
Vec<dim> resisting(const Model<dim>& model, const settings::StageSettings& stage)
{
  Vec<dim> along = Vec<dim>::Zero();
  if (stage.kind == settings::StageKind::push)
    along[model.axes.up] = model.axes.sign;
  else
    along[model.axes.along] = -drag_direction(stage);
  return along;
}

/// That component of a force of the soil on the body, N/m or N, in the present stage.
template <int dim>
Real resistance(const Model<dim>& model, const State<dim>& state, const Vec<dim>& reaction)
{
  return resisting(model, model.stages[state.stage.index]).dot(reaction);
}

/// The same of the driven body, as the mean that fades.
template <int dim>
Real mean_resistance(const Model<dim>& model, const State<dim>& state)
{
  return resistance(model, state, state.rigid_bodies[model.driven[state.stage.index]].recent.mean_force);
}

/// The value of a drive at a time since the stage's begin, s: it goes from what it was to its own, times a factor, over the stage's ramp.
inline Real ramped(const settings::StageSettings& stage, const bodies::Drive& drive, Real since, Real factor = 1)
{
  const Real fraction = stage.ramp > since ? since / stage.ramp : 1;
  return drive.from + fraction * (factor * drive.to - drive.from);
}

/// The freedom of a push down, or of a drag along x.
template <int dim>
int main_freedom(const Model<dim>& model, const settings::StageSettings& stage)
{
  return stage.kind == settings::StageKind::push ? model.axes.up : model.axes.along;
}

/// The force of the water on the driven body along a freedom of its drag, N/m: across, or downwards.
template <int dim>
Real load_of_water(const Model<dim>& model, const State<dim>& state, const settings::StageSettings& stage, int freedom, Real since);

/// The same of a freedom of the driven body that no displacement drives: a column of the load history gives its value; factors multiply what a push drives down and a drag along x, and
/// nothing else. Water makes forces by where the body is and how it moves.
template <int dim>
Real drive_now(const Model<dim>& model, const State<dim>& state, const settings::StageSettings& stage, const bodies::Drive& drive,
               int freedom, Real since)
{
  if (stage.water && freedom < dim) return ramped(stage, drive, since, load_of_water(model, state, stage, freedom, since));
  if (const int column = load_column_of(stage, model.axes, freedom); column != none)
    return ramped(stage, drive, since, load_of_column(stage, static_cast<std::size_t>(column), since));
  return ramped(stage, drive, since, freedom == main_freedom(model, stage) ? load_factor(stage, since) : 1);
}

/// Sets the drives of the stage that state.stage.index names, and where its tractions go. A velocity starts from the present velocity and a force from the one that drove the body before, or else
/// the one that balances the present reaction (RecentReaction; after a limit of force that which ended the stage), so that nothing jumps when the drive changes. What a push or a drive does not name is still at once: it
/// would coast through the ramp.
template <int dim>
void begin_stage(const Model<dim>& model, State<dim>& state);

/// Drives a freedom of the driven body otherwise than its stage says, from the next step on until another call or the end of the stage: by a velocity (m/s, rad/s)
/// or a force (N/m, in space N; of a rotation a moment, N or N m), at once. Throws InputError where the stage is no drive, or a spring or a load history is in it.
template <int dim>
void drive_otherwise(const Model<dim>& model, State<dim>& state, int freedom, bool by_force, Real value);

/// Whether the present stage lifts its body, by a velocity upwards or a force above the one that it began with: w and V then fall to their limits. Not by a
/// load history.
template <int dim>
bool lifts(const Model<dim>& model, const State<dim>& state);

/// Whether the resistance (N/m or N, as resistance() has it) has come to the stage's limit of force; false without one.
template <int dim>
bool force_reached(const Model<dim>& model, const State<dim>& state, Real resistance);

/// How far the resistance is beyond the limit of force that has ended the present stage, over that limit, without the lag of its mean; NaN where no such limit
/// has ended a drive by velocity.
template <int dim>
Real beyond_force_limit(const Model<dim>& model, const State<dim>& state);

/// True when a limit of the present stage is reached.
template <int dim>
bool stage_ended(const Model<dim>& model, const State<dim>& state);

/// The part of its velocity that a drive has near its limit of force F, so that the resistance R comes to it and not past it:
///
///   (1.01 F - R) / (2 k v tau), at most 1, with the secant stiffness k = dR/ds along the travel s:   dR/dt = (1.01 F - R) / (2 tau),
///
/// tau the time over which the reaction of a body that hardly moves fades. R is the mean and what it lags by that stiffness (ForceApproach::now), so that the drive keeps half of the critical damping in soil
/// four times as stiff as the secant. The mean decides that the limit is reached: R is 0.5 % beyond it then. 1 before R has begun to grow, without a limit, with a load history, and by a force.
template <int dim>
Real velocity_factor(const Model<dim>& model, const State<dim>& state, Real velocity);

/// The velocity and angular velocity of each rigid body in the coming step: given, or mass times acceleration = drive or weight + reaction of the last step and
/// inertia times angular acceleration = torque of the last step. Adds the work of gravity and drives on free bodies to the totals.
template <int dim>
void drive_rigids(const Model<dim>& model, State<dim>& state, Real dt);

/// Moves the rigid bodies by the velocities of this step and takes note of their reactions.
template <int dim>
void move_rigids(const Model<dim>& model, State<dim>& state);

/// The part of a traction or a head that acts at a time.
template <class Load>
Real acting_fraction(const Load& load, const TractionState& now, Real time)
{
  const Real since = time - now.begin_time, fraction = load.ramp > since ? since / load.ramp : 1;
  return now.from + fraction * (now.to - now.from);
}

/// The velocity that a condition prescribes at a time since the present stage began, m/s; 0 where it prescribes none, and in stages in which it does not act.
template <int dim>
Vec<dim> velocity_of(const boundary::NodalCondition<dim>& condition, const StageState<dim>& stage, Real since)
{
  Vec<dim> velocity = Vec<dim>::Zero();
  if (condition.acts[static_cast<std::size_t>(stage.index)])
    std::visit(
        [&](const auto& kind) {
          if constexpr (boundary::PrescribesVelocity<decltype(kind)>)
            for (int d = 0; d < dim; ++d) velocity[d] = kind.velocity(d, since);
        },
        condition.kind);
  return velocity;
}

/// Gravity at the present time, m/s2.
template <int dim>
Vec<dim> gravity_now(const Model<dim>& model, Real time)
{
  return boundary::ramped_gravity<dim>(model.gravity, model.gravity_ramp, time);
}

}  // namespace berm::problem
