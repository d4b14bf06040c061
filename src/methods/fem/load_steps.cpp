// SPDX-License-Identifier: BSD-3-Clause
#include "fem/load_steps.hpp"

#include "fem/stage_increments.hpp"

#include "os/error.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

constexpr Real release_viscosity = 0.1;
constexpr Real first_travel = 2e-4;      // of the width, in the first increment of a stage
constexpr Real max_energy_error = 0.03;  // in large deformations, of the work of an increment
constexpr Real past_the_end = 1 + 1e-6;  // so that rounding leaves no increment without length before the end of a stage
constexpr Real too_far = 1.001;          // of the travel between two meshes
constexpr Real short_increment = 0.01;   // over the first increment, or of the imbalance to be removed: energy is not asked for
constexpr Real loose = 10;               // times the tolerance: taken where even the smallest increment comes no nearer, once in a row
constexpr Real min_growth = 5e-3;        // of the width: an increment of this travel is never too long for the pressure that it brings
constexpr Real pressure_change = 0.02;   // of the contact force, in one increment
constexpr Real max_lag = 0.01;           // of what plastic flow dissipates: strength that is less behind its pressure follows no further
constexpr int max_passes = 4;            // in which the equilibrium of an increment is found, each with the strength of the one before
constexpr Real strength_part = 0.7;  // of the way to the strength just found, at least: all of it swings from side to side in a steady drag
constexpr Real max_lag_left = 0.8;   // a pass that leaves more of the lag is the last
constexpr Real max_pressure_error = 5e-5;  // of an increment, over the largest pressures of the stage, root mean squares of both
constexpr Real min_first_dt = 1e-3;  // of an increment where no water flows; none where the body moves, whose travel limits the increments
constexpr Real max_inertia_error = 1e-4;                       // of the movement of a body in an increment, over its width
constexpr Real little_inertia = 0.01;                          // of the contact force: its error limits nothing
constexpr Real max_overstress = 0.05;                          // of the stress of soil at yield
constexpr int few_iterations = 8, few_enough_iterations = 12;  // iterations

/// Throws RunError where water cavitates: the pressure of finite elements has no such limit.
void refuse_cavitation(const FemModel& model, const FemState& state)
{
  for (Index cell = 0; cell < model.flow.water.size(); ++cell) {
    if (!model.flow.in(cell)) continue;
    const int place = pore_pressure_index(model.soil_of(cell).materials.front());
    for (int q = 0; q < triangle_points; ++q)
      if (const Real p = state.points[cell][q].law_state[place], least = model.flow.water[cell][q].min_pressure; p < least)
        throw RunError(
            fmt::format("the water of {} cavitates at t = {:.6g} s: an excess pore pressure of {:.4g} kPa where {:.4g} kPa is the minimum; "
                        "finite elements cannot continue from there: take method = \"mpm\", or a larger water_depth",
                        model.model.bodies[model.mesh.body[cell]].name, state.state.time, p / 1e3, least / 1e3));
  }
}

/// The largest vertical stress of the soil by size, Pa.
Real largest_stress(const FemState& state)
{
  Real largest = 0;
  for (const auto& of_cell : state.points)
    for (const SoilPoint& point : of_cell) largest = std::max(largest, std::abs(point.stress[1]));
  return largest;
}

/// The largest magnitude of the excess pore pressure, Pa.
Real largest_pressure(const FemModel& model, const std::vector<Real>& unknowns)
{
  Real largest = 0;
  for (Index k = model.pressure_unknown(); k < model.unknowns(); ++k) largest = std::max(largest, std::abs(unknowns[k]));
  return largest;
}

/// Whether these loads accelerate a mass.
bool accelerate(const FemLoads& loads)
{
  return std::any_of(std::begin(loads.rigid), std::end(loads.rigid), [](const FemLoads::Direction& d) { return d.mass > 0; });
}

}  // namespace

LoadSteps::LoadSteps(FemModel& model, FemState& state, std::optional<Remesher> remesher)
    : model_(model),
      state_(state),
      remesher_(std::move(remesher)),
      newton_(std::make_unique<Newton>(model)),
      min_relaxation_((model.non_associated ? 0.5 : 1e-4) * model.settings.relaxation),
      relaxation_(model.non_associated ? model.settings.relaxation : min_relaxation_)
{
  begin();
}

void LoadSteps::find_first_equilibrium()
{
  max_overlap_ = 0;
  const FemLoads loads = dead_loads(0);
  FemLoads drained = loads;
  drained.drained = true;
  for (Real& factor : drained.tractions) factor = 0;
  if ((model_.flow.count > 0 && !release_imbalance(drained, release_viscosity)) || !release_imbalance(loads, release_viscosity))
    throw NoEquilibrium(
        "the soil is not in equilibrium at the start: it cannot carry its weight with these stresses (k0, strength, min_pressure)");
}

/// Holds back by fictitious forces what is out of balance under these loads, and takes these forces away; false where no equilibrium is found.
bool LoadSteps::release_imbalance(FemLoads loads, Real viscosity)
{
  newton_->assembly().store_initial_imbalance(state_, loads);
  state_.gravity = loads.gravity;
  state_.tractions = loads.tractions;
  state_.initial_imbalance_factor = 1;
  Real part = 1;
  while (state_.initial_imbalance_factor > 0) {
    loads.initial_imbalance_factor = std::max(Real(0), state_.initial_imbalance_factor - part);
    std::vector<Real> change(model_.unknowns(), 0.);
    const IncrementEnd end = newton_->find_equilibrium(state_, loads, viscosity, change);
    if (end.converged && (part < short_increment || keeps_energy(change, loads))) {
      imbalance_work_ += newton_->assembly().work_of_imbalance(state_, change, loads);
      accept_equilibrium(change, loads);
      part *= 1.5;
    } else if ((part /= 2) < 1e-4) {
      return false;
    }
  }
  return true;
}

void LoadSteps::accept_equilibrium(const std::vector<Real>& change, const FemLoads& loads)
{
  newton_->assembly().accept(state_, change, loads);
  if (model_.settings.large_deformation) place_contact(model_, state_);
  if (remesher_) remesher_->refuse_bodies_that_meet(model_, state_);
  for (const FemContactState& point : state_.contact) max_overlap_ = std::max(max_overlap_, -point.gap);
}

/// The prescribed speed of the driven body in this stage, m/s: of its centre, and of its sides where it turns.
Real LoadSteps::speed_of_body() const
{
  if (driven() == none) return 0;
  const auto prescribed = [&](int freedom) {
    const bodies::Drive& drive = state_.state.stage.drive[freedom];
    return drive.by_force ? 0 : drive.to;
  };
  return std::hypot(std::hypot(prescribed(0), prescribed(1)), prescribed(2) * model_.width / 2);
}

/// The mass (moment of inertia) that a force accelerates in this stage, kg/m (kg m). None where a motion is prescribed: the time of such a stage is a measure of travel only.
Real LoadSteps::mass_of_body(int freedom) const
{
  if (!remesher_ || driven() == none || speed_of_body() > 0 || !state_.state.stage.drive[freedom].by_force) return 0;
  const bodies::RigidBody<2>& body = model_.model.rigid_bodies[driven()];
  return freedom < 2 ? body.mass : body.inertia;
}

/// What the movement of the body may be wrong by, over the width: half of what it differs from that without acceleration. 0 where inertia is small beside the contact force.
Real LoadSteps::inertia_error(const std::vector<Real>& change, const FemLoads& loads) const
{
  Real force = 0, error = 0;
  for (int d = 0; d < 2; ++d)
    if (const FemLoads::Direction& direction = loads.rigid[d]; direction.mass > 0) {
      const Real bend = change[model_.rigid_unknown(loads.moved) + d] - loads.dt * direction.velocity;
      force = std::hypot(force, direction.mass * bend / (loads.dt * loads.dt));
      error = std::hypot(error, bend / 2);
    }
  return force > little_inertia * newton_->assembly().contact_force() ? error / model_.width : 0;
}

void LoadSteps::begin()
{
  const settings::StageSettings& now = stage();
  const Real speed = speed_of_body();
  const bool moves = speed > 0;
  first_dt_ = moves ? first_travel * model_.width / speed + (now.ramp > 0 ? now.ramp / 100 : 0)
                    : (now.ramp > 0 ? now.ramp : now.until.time.value_or(1)) / (50 * model_.patience);
  shortest_dt_ = (moves || model_.flow.count == 0 ? 1 : min_first_dt) * first_dt_;
  dt_ = model_.flow.count > 0 ? std::clamp(model_.flow.first_dt, shortest_dt_, first_dt_) : first_dt_;
  last_dt_ = 0;
  largest_pressure_ = 0;
}

/// Gravity, tractions and heads at a time.
FemLoads LoadSteps::dead_loads(Real time) const
{
  FemLoads loads;
  loads.gravity = gravity_now(model_.model, time);
  for (std::size_t t = 0; t < model_.loads.size(); ++t)
    loads.tractions.push_back(acting_fraction(model_.model.tractions[t], state_.state.tractions[t], time));
  boundary::for_each_of<boundary::Head<2>>(model_.model.conditions, [&](std::size_t h, const auto& row, const auto& head) {
    loads.heads.push_back(acting_fraction(row, state_.state.heads[h], time) * head.pressure);
  });
  return loads;
}

FemLoads LoadSteps::loads_after(Real dt) const
{
  FemLoads loads = dead_loads(state_.state.time + dt);
  loads.dt = dt;
  if (driven() == none) return loads;
  loads.moved = model_.contact_of(driven());
  const bodies::RigidState<2>& body = state_.state.rigid_bodies[driven()];
  const problem::StageState<2>& now = state_.state.stage;
  const Real since = state_.state.time - now.begin_time;
  for (int f = 0; f < bodies::freedoms<2>; ++f) {
    const bodies::Drive& drive = now.drive[f];
    loads.rigid[f] = {drive.by_force,
                      drive.by_force ? drive_now(model_.model, state_.state, stage(), drive, f, since + dt)
                                     : travel_of_drive(stage(), now.drive[f], since, since + dt),
                      mass_of_body(f), f < 2 ? body.velocity[f] : body.angular_velocity};
    if (loads.rigid[f].mass > 0 && dt == 0) loads.rigid[f] = {};  // held while time stands still
  }
  return loads;
}

/// The equilibrium at the end of an increment; again with the strength there, as long as it lags and another pass helps. A pass that finds none or lags
/// more is taken back.
IncrementEnd LoadSteps::find_equilibrium(const FemLoads& loads, Real dt, std::vector<Real>& change)
{
  const Real viscosity = viscosity_of(dt);
  Assembly& assembly = newton_->assembly();
  IncrementEnd end = newton_->find_equilibrium(state_, loads, viscosity, change);
  last_iterations_ = end.iterations;
  if (!model_.non_associated) return end;
  end.lag = assembly.strength_lag(state_, change);
  Real part = strength_part;
  for (int pass = 1; pass < max_passes && end.converged && std::abs(end.lag.part()) > max_lag; ++pass) {
    const std::vector<Real> before = change;
    assembly.update_strength(part);
    IncrementEnd next = newton_->find_equilibrium(state_, loads, viscosity, change);
    const int iterations = end.iterations + next.iterations;
    next.lag = assembly.strength_lag(state_, change);
    const Real ratio = next.lag.part() / end.lag.part(), left = std::abs(ratio);
    part = std::clamp(part / (1 - ratio), strength_part, Real(1));  // where the lag would vanish, along its chord
    if (!next.converged || left > 1) {
      change = before;
      assembly.undo_strength_update();
      assembly.evaluate(state_, change, loads, viscosity);
    } else {
      last_iterations_ = next.iterations;
      end = next;
    }
    end.iterations = iterations;
    if (!next.converged || left > max_lag_left) break;
  }
  assembly.reset_strength();
  return end;
}

/// The mesh anew, and the equilibrium there: what moves the body by its displacement holds it, what moves it by a force goes on acting.
void LoadSteps::remesh()
{
  const std::vector<bodies::RigidState<2>> before = state_.state.rigid_bodies;
  const Content old = content_of(model_, state_);
  remeshings_.folds += remesher_->remesh(model_, state_);
  const Content mapped = content_of(model_, state_);
  imbalance_work_ = 0;
  newton_ = std::make_unique<Newton>(model_);
  last_dt_ = 0;
  // Viscosity makes it sooner; in sand, whose strength follows its pressure, it leaves too much.
  if (!(model_.non_associated && release_imbalance(loads_after(0), viscosity_of(dt_))) &&
      !release_imbalance(loads_after(0), release_viscosity))
    throw NoEquilibrium(fmt::format("t = {:.6g} s: the soil has no equilibrium after remeshing", state_.state.time));
  const std::vector<bodies::RigidState<2>>& after = state_.state.rigid_bodies;
  for (std::size_t r = 0; r < after.size(); ++r) {
    const Real force = before[r].reaction.norm(), change = (after[r].reaction - before[r].reaction).norm();
    remeshings_.largest_force = std::max(remeshings_.largest_force, force);
    remeshings_.largest_change = std::max(remeshings_.largest_change, change);
    remeshings_.sum_of_forces += force;
    remeshings_.sum_of_changes += change;
  }
  remeshings_.lost_energy += old.energy - mapped.energy - imbalance_work_;
  remeshings_.lost_area += old.area - mapped.area;
  ++remeshings_.count;
}

/// Of an increment of dt (s): by the travel of a stage with a prescribed speed, or of a body that forces move faster.
Real LoadSteps::viscosity_of(Real dt) const
{
  const Real travel = driven() == none ? 0 : state_.state.rigid_bodies[driven()].velocity.norm() * first_dt_ / model_.width;
  return relaxation_ / std::max(first_travel, travel) * (first_dt_ / dt);
}

/// In large deformations no increment is longer than the travel asked for, nor than a quarter of that between two meshes.
Real LoadSteps::longest_dt() const
{
  if (shortest_dt_ < first_dt_) return infinity;
  const Real longest = first_dt_ * std::max(Real(1), model_.settings.largest_step / first_travel), speed = speed_of_body();
  if (!remesher_ || !(speed > 0)) return longest;
  return std::min(longest, std::min(model_.settings.largest_step, model_.settings.remeshing_travel / 4) * model_.width / speed);
}

/// Whether an increment takes the body, which a force may move, farther than it may go between two meshes: soil without contact points would meet it.
bool LoadSteps::goes_too_far(const std::vector<Real>& change) const
{
  if (!remesher_ || driven() == none) return false;
  const Index first = model_.rigid_unknown(model_.contact_of(driven()));
  Vec<3> end;
  for (int d = 0; d < 3; ++d) end[d] = state_.displacement[first + d] + change[first + d];
  const Real travel = distance_between<2>(model_.model.rigid_bodies[driven()], state_.state.rigid_bodies[driven()], pose_of(end));
  return travel > too_far * model_.settings.remeshing_travel * model_.width;
}

/// Whether an increment conserves energy: not where an element is turned inside out between its start and its end.
bool LoadSteps::keeps_energy(const std::vector<Real>& change, const FemLoads& loads)
{
  return !remesher_ || newton_->assembly().energy_error(state_, change, loads) < max_energy_error;
}

IncrementEnd LoadSteps::advance()
{
  max_overlap_ = 0;
  if (remesher_ && remesher_->is_due(model_, state_)) remesh();
  const Real largest_dt = longest_dt();
  Real shortest = 1;  // where a limit of force cuts the increment
  for (;;) {
    const Real dt = up_to_the_end(model_.model, state_.state, std::min(dt_, largest_dt) * shortest * (remesher_ ? past_the_end : 1));
    const FemLoads loads = loads_after(dt);
    std::vector<Real> change(model_.unknowns(), 0.);
    if (last_dt_ > 0)
      for (std::size_t k = 0; k < change.size(); ++k) change[k] = last_change_[k] * (dt / last_dt_);
    const IncrementEnd end = find_equilibrium(loads, dt, change);
    if (const Real part = end.converged ? part_within_force(model_.model, state_.state, reaction_now()) : 1; part < 1 && shortest > 1e-6) {
      shortest *= part;
      continue;
    }
    if (end.converged && (goes_too_far(change) || inertia_error(change, loads) > 4 * max_inertia_error)) {
      dt_ = dt / 2;
      if (dt_ < 1e-4 * first_dt_)
        throw NoEquilibrium(fmt::format("stage \"{}\": nothing stops the rigid body at t = {:.6g} s", stage().name, state_.state.time));
      continue;
    }
    const bool kept = !end.converged || dt < short_increment * first_dt_ || keeps_energy(change, loads);
    const bool last_resort = !accepted_above_tolerance_ && dt < 2e-4 * first_dt_ && end.unbalance <= loose * model_.settings.tolerance;
    if ((end.converged && kept) || last_resort) {
      const Vec<2> before = driven() == none ? Vec<2>(Vec<2>::Zero()) : state_.state.rigid_bodies[driven()].reaction;
      accept_equilibrium(change, loads);
      const Real force = newton_->assembly().contact_force();
      accept(change, loads, end, force > 0 ? (newton_->assembly().reaction(loads.moved) - before).norm() / force : 0);
      refuse_cavitation(model_, state_);
      if (state_.overstress > max_overstress && driven() != none && !accelerate(loads)) refuse_overstress();
      return end;
    }
    dt_ = dt / 2;
    relaxation_ = std::min(4 * relaxation_, model_.settings.relaxation);
    if (dt_ < last_dt_ / 8) last_dt_ = 0;  // the last increment is no guide any more
    if (dt_ >= 1e-4 * first_dt_) continue;
    if (!remesher_ || Remesher::travel_since_mesh(model_, state_) == 0)
      throw NoEquilibrium(fmt::format(
          "stage \"{}\": no equilibrium at t = {:.6g} s, even with an increment of {:.2g} s; the unbalanced forces stay at {:.2g} "
          "of the contact forces. A larger fem.relaxation (now {}) or a finer mesh may help",
          stage().name, state_.state.time, dt, end.unbalance, model_.settings.relaxation));
    remesh();
    dt_ = first_dt_;
  }
}

/// The increment to follow one of dt (s) as far as the water is concerned: backward Euler errs by half of how much the change of pressure differs from that of
/// the increment before, scaled to the same duration, and the square of dt. To be called before the change replaces the last one.
Real LoadSteps::next_dt_of_flow(const std::vector<Real>& change, Real dt)
{
  if (last_dt_ == 0) return dt;
  Real pressure = 0, error = 0;
  for (Index k = model_.pressure_unknown(); k < model_.unknowns(); ++k) {
    pressure += state_.displacement[k] * state_.displacement[k];
    const Real bend = (change[k] - last_change_[k] * (dt / last_dt_)) / 2;
    error += bend * bend;
  }
  largest_pressure_ = std::max(largest_pressure_, pressure);
  // Round-off of pressures that the soil does not feel has no length.
  constexpr Real not_felt = 1e-10;
  const Real felt = not_felt * largest_stress(state_);
  if (error <= felt * felt * static_cast<Real>(model_.flow.count)) return infinity;
  return error > 0 ? dt * std::sqrt(max_pressure_error * std::sqrt(largest_pressure_ / error)) : infinity;
}

void LoadSteps::accept(const std::vector<Real>& change, const FemLoads& loads, const IncrementEnd& end, Real force_change)
{
  const Real dt = loads.dt;
  Real longest = model_.flow.count > 0 ? std::max(next_dt_of_flow(change, dt), shortest_dt_) : infinity;
  if (const Real error = inertia_error(change, loads); error > 0) longest = std::min(longest, dt * std::sqrt(max_inertia_error / error));
  note_velocity(change, loads);
  state_.state.time += dt;
  ++state_.state.step;
  if (model_.flow.count > 0) {
    state_.state.stage.excess_pressure = largest_pressure(model_, state_.displacement);
    note_without_waves(state_.state.stage.pressure_means, state_.state.stage.excess_pressure);
  }
  last_change_ = change;
  last_dt_ = dt;
  if (last_iterations_ <= few_iterations) relaxation_ = std::max(relaxation_ / 4, min_relaxation_);
  if (last_iterations_ <= few_enough_iterations) dt_ = std::max(dt_, dt * 1.5);
  if (model_.non_associated) dt_ = std::min(dt_, std::max(dt * pressure_change / force_change, first_dt_ * min_growth / first_travel));
  dt_ = std::min(dt_, longest);
  accepted_above_tolerance_ = !end.converged;
  if (accepted_above_tolerance_) dt_ = first_dt_;
}

/// The velocity that a force gives to the mass of the body; where nothing is accelerated it is none.
void LoadSteps::note_velocity(const std::vector<Real>& change, const FemLoads& loads)
{
  if (driven() == none) return;
  bodies::RigidState<2>& body = state_.state.rigid_bodies[driven()];
  const auto velocity = [&](int f) {
    const Real mean = change[model_.rigid_unknown(loads.moved) + f] / loads.dt;
    return loads.rigid[f].mass > 0 ? (mean - (1 - weight_of_end) * loads.rigid[f].velocity) / weight_of_end : 0;
  };
  body.velocity = Vec<2>(velocity(0), velocity(1));
  body.angular_velocity = velocity(2);
}

void LoadSteps::refuse_overstress() const
{
  throw NoEquilibrium(fmt::format(
      "stage \"{}\": the soil cannot carry the force at t = {:.6g} s: {:.2g} of its stress is beyond its strength, in viscous flow only; "
      "there is no inertia that could carry the body past a peak of the load: take a smaller load, {}",
      stage().name, state_.state.time, state_.overstress,
      remesher_ ? "or give the body a mass" : "fem.large_deformation = true and a body with a mass, or method = \"mpm\""));
}

bool LoadSteps::next_stage()
{
  max_overlap_ = 0;
  if (state_.state.stage.index + 1 == static_cast<Index>(model_.model.stages.size())) return false;
  const Index held = model_.model.conditions.table_of_stage[state_.state.stage.index];
  ++state_.state.stage.index;
  if (model_.model.conditions.table_of_stage[state_.state.stage.index] != held &&
      !release_imbalance(dead_loads(state_.state.time), release_viscosity))
    throw NoEquilibrium(
        fmt::format("stage \"{}\": the soil does not reach equilibrium without the supports that are released", stage().name));
  begin_stage(model_.model, state_.state);
  if (const Real share = stage().strength_recovery; share > 0)
    for (Index cell = 0; cell < state_.points.size(); ++cell)
      for (int q = 0; q < triangle_points; ++q) recover(model_.soil_at(cell, q), share, state_.points[cell][q].law_state.data());
  begin();
  return true;
}

void LoadSteps::archive_mesh(Archive& k)
{
  fem::archive_mesh(k, remesher_->settings(), model_, state_);
  if (k.reads()) newton_ = std::make_unique<Newton>(model_);
}

void LoadSteps::archive(Archive& k)
{
  k("relaxation", relaxation_);
  k("first_dt", first_dt_);
  k("shortest_dt", shortest_dt_);
  k("dt", dt_);
  k("last_dt", last_dt_);
  k("last_iterations", last_iterations_);
  k("accepted_above_tolerance", accepted_above_tolerance_);
  k("largest_pressure", largest_pressure_);
  if (remesher_) {
    k("remeshings", remeshings_.count);
    k("largest_change", remeshings_.largest_change);
    k("largest_force", remeshings_.largest_force);
    k("sum_of_changes", remeshings_.sum_of_changes);
    k("sum_of_forces", remeshings_.sum_of_forces);
    k("folds", remeshings_.folds);
    k("lost_energy", remeshings_.lost_energy);
    k("lost_area", remeshings_.lost_area);
  }
  k("last_change", last_change_);
  if (!(relaxation_ > 0 && first_dt_ > 0 && dt_ > 0 && last_dt_ >= 0)) k.refuse("its increments have no length");
  if (last_dt_ > 0 && static_cast<Index>(last_change_.size()) != model_.unknowns()) k.refuse("its last increment is of another mesh");
}

}  // namespace berm::fem
