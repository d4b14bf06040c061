// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/stages.hpp"

#include <algorithm>

// Where the limits of a stage cut its increments.

namespace berm::fem {

/// What a drive by velocity does between two times since its stage began, m or rad: the velocity grows over the ramp.
inline Real travel_of_drive(const settings::StageSettings& stage, const bodies::Drive& drive, Real from, Real to)
{
  const Real ramp = stage.ramp;
  const auto until = [&](Real t) { return t < ramp ? drive.to * t * t / (2 * ramp) : drive.to * (t - ramp / 2); };
  return drive.by_force ? 0 : until(to) - until(from);
}

/// An increment of dt (s) cut where the present stage ends by its time, displacement or embedment, or where its load history, which is linear within an increment, bends.
template <int dim>
Real up_to_the_end(const problem::Model<dim>& model, const problem::State<dim>& state, Real dt)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const Index driven = model.driven[state.stage.index];
  const problem::StageState<dim>& now = state.stage;
  const settings::Until& until = stage.until;
  const Real since = state.time - now.begin_time;
  if (until.time) dt = std::min(dt, *until.time - since);
  if (driven == none) return dt;
  const auto cut = [&](const auto& gone_after, Real left) {
    Real low = 0, high = dt;
    if (gone_after(dt) <= left) return;
    for (int k = 0; k < 60; ++k) {
      const Real middle = (low + high) / 2;
      (gone_after(middle) < left ? low : high) = middle;
    }
    dt = high;
  };
  const auto travel = [&](int freedom, Real step) { return travel_of_drive(stage, now.drive[freedom], since, since + step); };
  const auto along = [&](int direction) { return [&, direction](Real step) { return std::abs(travel(direction, step)); }; };
  const Vec<dim> moved = state.rigid_bodies[driven].displacement - now.begin_displacement;
  const auto distance = [&](Real step) {
    Vec<dim> all = moved;
    for (int d = 0; d < dim; ++d) all[d] += travel(d, step);
    return all.norm();
  };
  const int up = model.axes.up, level = model.axes.along;
  if (until.displacement && stage.kind == settings::StageKind::drive)
    cut(distance, *until.displacement);
  else if (until.displacement)
    cut(along(level), *until.displacement - std::abs(moved[level]));
  if (until.embedment && travel(up, dt) != 0) {
    const Real left = *until.embedment - travel_of(model, state, driven).w;
    cut(along(up), lifts(model, state) ? -left : left);
  }
  constexpr Real round_off = 1e-9;
  for (const Real time : stage.load_times)
    if (const Real left = time * stage.time_scale - since; left > round_off * dt) return std::min(dt, left);
  return dt;
}

/// The part of an increment that ends with this reaction of the driven body (N/m or N) after which the stage's limit of force is reached; 1 where it is not.
template <int dim>
Real part_within_force(const problem::Model<dim>& model, const problem::State<dim>& state, const Vec<dim>& reaction)
{
  const std::optional<Real>& limit = model.stages[state.stage.index].until.force;
  const Index driven = model.driven[state.stage.index];
  if (!limit || driven == none) return 1;
  const Real before = resistance(model, state, state.rigid_bodies[driven].reaction), after = resistance(model, state, reaction);
  const Real direction = lifts(model, state) ? -1 : 1;
  return direction * (after - *limit) > std::abs(*limit) * 1e-4 ? std::max(0.1, (*limit - before) / (after - before)) : 1;
}

}  // namespace berm::fem
