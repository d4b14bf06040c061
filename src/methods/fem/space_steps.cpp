// SPDX-License-Identifier: BSD-3-Clause
#include "fem/space_steps.hpp"

#include "fem/stage_increments.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

constexpr Real release_viscosity = 0.1;
constexpr Real first_travel = 2e-4;    // of the width, in the first increment of a stage
constexpr Real loose = 10;             // times the tolerance: taken where even the smallest increment comes no nearer, once in a row
constexpr Real max_overstress = 0.05;  // of the stress of soil at yield
constexpr int few_iterations = 8, few_enough_iterations = 16;

}  // namespace

SpaceSteps::SpaceSteps(const SpaceModel& model, SpaceState& state)
    : model_(model),
      state_(state),
      newton_(model),
      min_relaxation_(1e-4 * model.settings.relaxation),
      relaxation_(min_relaxation_)
{
  begin();
}

void SpaceSteps::begin()
{
  Real speed = 0;
  if (driven() != none)
    for (int f = 0; f < 6; ++f)
      if (const bodies::Drive& drive = state_.state.stage.drive[f]; !drive.by_force)
        speed = std::hypot(speed, drive.to * (f < 3 ? 1 : model_.width / 2));
  const Real ramp = stage().ramp;
  first_dt_ = speed > 0 ? first_travel * model_.width / speed + ramp / 100 : (ramp > 0 ? ramp : stage().until.time.value_or(1)) / 50;
  longest_dt_ = speed > 0 ? first_dt_ * std::max(Real(1), model_.settings.largest_step / first_travel) : infinity;
  dt_ = first_dt_;
  last_dt_ = 0;
}

ElementLoads<3> SpaceSteps::dead_loads(Real time) const
{
  ElementLoads<3> loads;
  loads.gravity = gravity_now(model_.model, time);
  return loads;
}

ElementLoads<3> SpaceSteps::loads_after(Real dt) const
{
  ElementLoads<3> loads = dead_loads(state_.state.time + dt);
  loads.dt = dt;
  if (driven() == none) return loads;
  loads.moved = model_.contact_of(driven());
  const problem::StageState<3>& now = state_.state.stage;
  const Real since = state_.state.time - now.begin_time;
  for (int f = 0; f < 6; ++f) {
    const bodies::Drive& drive = now.drive[f];
    loads.rigid[f].by_force = drive.by_force;
    loads.rigid[f].value = drive.by_force ? drive_now(model_.model, state_.state, stage(), drive, f, since + dt)
                                          : travel_of_drive(stage(), drive, since, since + dt);
  }
  return loads;
}

/// Holds back by fictitious forces what is out of balance at rest, and takes these forces away; false where no equilibrium is found.
bool SpaceSteps::release_imbalance()
{
  ElementLoads<3> loads = dead_loads(state_.state.time);
  newton_.assembly().store_initial_imbalance(state_, loads);
  state_.gravity = loads.gravity;
  state_.initial_imbalance_factor = 1;
  Real part = 1;
  while (state_.initial_imbalance_factor > 0) {
    loads.initial_imbalance_factor = std::max(Real(0), state_.initial_imbalance_factor - part);
    std::vector<Real> change(static_cast<std::size_t>(model_.unknowns()), 0.);
    if (newton_.find_equilibrium(state_, loads, release_viscosity, change).converged) {
      newton_.assembly().accept(state_, change, loads);
      part *= 1.5;
    } else if ((part /= 2) < 1e-4) {
      return false;
    }
  }
  return true;
}

void SpaceSteps::find_first_equilibrium()
{
  if (!release_imbalance())
    throw NoEquilibrium("the soil is not in equilibrium at the start: it cannot carry its weight with these stresses (k0, strength), or "
                        "its supports do not hold it");
}

IncrementEnd SpaceSteps::advance()
{
  Real shortest = 1;  // where a limit of force cuts the increment
  for (;;) {
    const Real dt = up_to_the_end(model_.model, state_.state, std::min(dt_, longest_dt_) * shortest);
    const ElementLoads<3> loads = loads_after(dt);
    std::vector<Real> change(static_cast<std::size_t>(model_.unknowns()), 0.);
    if (last_dt_ > 0)
      for (std::size_t k = 0; k < change.size(); ++k) change[k] = last_change_[k] * (dt / last_dt_);
    const IncrementEnd end = newton_.find_equilibrium(state_, loads, relaxation_ / first_travel * (first_dt_ / dt), change);
    if (end.converged && driven() != none)
      if (const Real part = part_within_force<3>(model_.model, state_.state, newton_.assembly().reaction(loads.moved));
          part < 1 && shortest > 1e-6) {
        shortest *= part;
        continue;
      }
    const bool last_resort = !accepted_above_tolerance_ && dt < 2e-4 * first_dt_ && end.unbalance <= loose * model_.settings.tolerance;
    if (end.converged || last_resort) {
      accept(change, loads, end);
      return end;
    }
    dt_ = dt / 2;
    relaxation_ = std::min(4 * relaxation_, model_.settings.relaxation);
    if (dt_ < last_dt_ / 8) last_dt_ = 0;  // the last increment is no guide any more
    if (dt_ < 1e-4 * first_dt_)
      throw NoEquilibrium(fmt::format(
          "stage \"{}\": no equilibrium at t = {:.6g} s, even with an increment of {:.2g} s; the unbalanced forces stay at {:.2g} "
          "of the contact forces. A larger fem.relaxation (now {}) or a finer mesh may help",
          stage().name, state_.state.time, dt, end.unbalance, model_.settings.relaxation));
  }
}

void SpaceSteps::accept(const std::vector<Real>& change, const ElementLoads<3>& loads, const IncrementEnd& end)
{
  newton_.assembly().accept(state_, change, loads);
  state_.state.time += loads.dt;
  ++state_.state.step;
  last_change_ = change;
  last_dt_ = loads.dt;
  if (end.iterations <= few_iterations) relaxation_ = std::max(relaxation_ / 4, min_relaxation_);
  if (end.iterations <= few_enough_iterations) dt_ = std::max(dt_, loads.dt * 1.5);
  accepted_above_tolerance_ = !end.converged;
  if (accepted_above_tolerance_) dt_ = first_dt_;
  if (state_.overstress > max_overstress && driven() != none)
    throw NoEquilibrium(fmt::format(
        "stage \"{}\": the soil cannot carry the force at t = {:.6g} s: {:.2g} of its stress is beyond its strength, in viscous "
        "flow only: take a smaller load, or method = \"mpm\"",
        stage().name, state_.state.time, state_.overstress));
}

bool SpaceSteps::next_stage()
{
  if (state_.state.stage.index + 1 == static_cast<Index>(model_.model.stages.size())) return false;
  const std::vector<Index>& table_of = model_.model.conditions.table_of_stage;
  const Index held = table_of[state_.state.stage.index];
  ++state_.state.stage.index;
  if (table_of[state_.state.stage.index] != held && !release_imbalance())
    throw NoEquilibrium(
        fmt::format("stage \"{}\": the soil does not reach equilibrium without the supports that are released", stage().name));
  begin_stage(model_.model, state_.state);
  begin();
  return true;
}

void SpaceSteps::archive(Archive& k)
{
  k("relaxation", relaxation_);
  k("first_dt", first_dt_);
  k("longest_dt", longest_dt_);
  k("dt", dt_);
  k("last_dt", last_dt_);
  k("accepted_above_tolerance", accepted_above_tolerance_);
  k("last_change", last_change_);
  if (!(relaxation_ > 0 && first_dt_ > 0 && dt_ > 0 && last_dt_ >= 0)) k.refuse("its increments have no length");
  if (last_dt_ > 0 && static_cast<Index>(last_change_.size()) != model_.unknowns()) k.refuse("its last increment is of another mesh");
}

}  // namespace berm::fem
