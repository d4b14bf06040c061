// SPDX-License-Identifier: BSD-3-Clause
#include "slices/coupled_line.hpp"

#include "core/for_each_task.hpp"
#include "core/ranks.hpp"
#include "mpm/contact_mass.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/inactive.hpp"
#include "mpm/step.hpp"
#include "mpm/time_step.hpp"
#include "os/error.hpp"
#include "problem/archive_state.hpp"
#include "problem/lengthen.hpp"
#include "problem/stages.hpp"
#include "slices/line_on_springs.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace berm::slices {
namespace {

/// Of ranks one may fail where others do not: what failed is told to all before any of them throws.
template <class Act>
void noting(std::string& fault, const Act& act)
{
  if (Ranks::of_run().count() == 1) return act();
  try {
    act();
  } catch (const RunError& error) {
    fault = error.what();
  }
}

void drive(const problem::Model<2>& model, problem::State<2>& state, Real sideways, Real upwards)
{
  drive_otherwise(model, state, 0, false, sideways);
  drive_otherwise(model, state, 1, false, upwards);
}

}  // namespace

CoupledLine::CoupledLine(const settings::Case& c, const problem::Model<2>& model)
    : of_case_(c),
      soils_(count(), Soil{&model, nullptr}),
      state_(beam::state_of(of_case_.line)),
      work_(of_case_.line),
      loads_(beam::no_loads(of_case_.line)),
      from_(of_case_.laid()),
      forces_(count()),
      sideways_(count()),
      upwards_(count()),
      impedances_(count()),
      spring_parts_(count()),
      resistances_(count()),
      springs_sideways_(count()),
      springs_upwards_(count()),
      before_(of_case_.line.freedoms()),
      moved_(of_case_.line.freedoms()),
      spring_forces_(of_case_.line.freedoms()),
      on_springs_(of_case_.length_beyond),
      along_(static_cast<std::size_t>(of_case_.line.nodes()))
{
  begin_as_springs();
}

void CoupledLine::make_others(const problem::State<2>& first)
{
  others_.clear();
  workspaces_.clear();
  for (std::size_t k = 1; k < count(); ++k) {
    others_.push_back(std::make_unique<problem::State<2>>(soils_[k].laid == nullptr ? first : *soils_[k].laid));
    problem::State<2>& other = *others_.back();
    other.time = first.time;  // laying may have taken another time there
    other.step = first.step;
    other.stage.begin_time = first.stage.begin_time;
    other.stable_dt_holds = first.stable_dt_holds;
  }
}

/// Of the slices that this rank steps; of the others it keeps how their pipes move.
void CoupledLine::begin_soils()
{
  for (std::size_t k = 1; k < count(); ++k) {
    problem::State<2>& other = *others_[k - 1];
    workspaces_.push_back(own(static_cast<Index>(k)) ? std::make_unique<mpm::Workspace<2>>(model_of(k), other) : nullptr);
    if (!own(static_cast<Index>(k)) && !Ranks::of_run().is_first())
      for (bodies::Particles<2>& particles : other.particles) particles = {};
  }
}

void CoupledLine::couple(const problem::State<2>& laid)
{
  coupled_ = true;
  laid_embedment_ = travel_of(model_of(0), laid, 0).w;
  make_others(laid);
  begin_soils();
  for (std::size_t k = 0; k < count(); ++k) forces_[k].force = (k == 0 ? laid : *others_[k - 1]).rigid_bodies[0].recent.force();
}

void CoupledLine::begin_stage(const problem::State<2>& first)
{
  // Where the stage before has brought the loads; before the first of kind pipeline: as the line was laid.
  from_ = of_case_.laid();
  for (Index k = 0; k < first.stage.index; ++k) from_ = end_of(model_of(0).stages[k], from_);
  for (std::size_t k = 1; k < count(); ++k) {
    problem::State<2>& other = *others_[k - 1];
    if (other.stage.index == first.stage.index) continue;  // copied when the first one had begun it
    other.stage.index = first.stage.index;
    problem::begin_stage(model_of(k), other);
  }
}

LineLoads CoupledLine::loads_at(const problem::State<2>& first, Real time) const
{
  const settings::StageSettings& stage = model_of(0).stages[first.stage.index];
  if (stage.kind != settings::StageKind::pipeline) return of_case_.laid();
  return loads_in(stage, from_, time - first.stage.begin_time);
}

/// What acts on the line at the end of the step: weight, and what the soil carried in the step before.
void CoupledLine::load_line(const LineLoads& now, Real dt)
{
  const beam::Line& line = of_case_.line;
  put_loads(of_case_, now, on_springs_, loads_);
  std::fill(loads_.impedance.begin(), loads_.impedance.end(), 0.0);
  loads_.velocity_then = state_.velocity;
  for (std::size_t k = 0; k < count(); ++k) {
    const SliceForce soil = is_spring(k) ? SliceForce() : forces_[k];
    sideways_[k] = soil.force[0], upwards_[k] = soil.force[1];
    impedances_[k] = std::max(Real(0), 3 * soil.contact_mass - of_case_.mass) / dt;
  }
  of_case_.stations.add_forces(line, beam::Direction::lateral, sideways_, loads_);
  of_case_.stations.add_forces(line, beam::Direction::vertical, upwards_, loads_);
  of_case_.stations.add_impedances(line, beam::Direction::lateral, impedances_, loads_);
  of_case_.stations.add_impedances(line, beam::Direction::vertical, impedances_, loads_);
}

/// An error tells in which slice it is.
template <class Act>
void CoupledLine::for_slice(Index k, const Act& act) const
{
  try {
    act();
  } catch (const RunError& error) {
    throw RunError(
        fmt::format("slice {} of the pipeline, at x = {:.4g} m: {}", k, of_case_.places[static_cast<std::size_t>(k)], error.what()));
  }
}

void CoupledLine::find_time_steps(problem::State<2>& first, mpm::Workspace<2>& workspace)
{
  if (first.stable_dt_holds || is_spring(0)) return;
  resolve();
  std::string fault;
  noting(fault, [&] {
    for_each_task("time steps of slices", static_cast<Index>(count()), [&](Index k) {
      if (!own(k) || (k > 0 && is_spring(static_cast<std::size_t>(k)))) return;  // the first one's is the clock of all
      for_slice(k, [&] {
        if (k == 0)
          find_stable_time_step(model_of(0), first, workspace);
        else
          find_stable_time_step(model_of(k), *others_[k - 1], *workspaces_[k - 1]);
      });
    });
  });
  share_time_steps(first, fault);
}

/// Moves the line by a step of dt (s), or a half, quarter, ... of it where it finds no equilibrium. Returns the step.
Real CoupledLine::step_line(const problem::State<2>& first, Real dt)
{
  constexpr int tries = 6;
  const Timer timer("pipeline");
  before_ = state_.displacement;
  for (int k = 1;; ++k) try {
      load_line(loads_at(first, first.time + dt), dt);
      beam::step(of_case_.line, loads_, dt, state_, work_);
      break;
    } catch (const beam::NoEquilibrium&) {
      if (k == tries) throw;
      dt /= 2;
    }
  for (Index i = 0; i < of_case_.line.freedoms(); ++i) moved_[i] = (state_.displacement[i] - before_[i]) / dt;
  of_case_.stations.means(of_case_.line, beam::Direction::lateral, moved_, sideways_);
  of_case_.stations.means(of_case_.line, beam::Direction::vertical, moved_, upwards_);
  return dt;
}

/// The shortest of all slices that are soil; of a line on springs a part of its stage.
Real CoupledLine::time_step(const problem::State<2>& first) const
{
  constexpr Real longest = 0.01, parts = 500;  // s
  if (is_spring(0)) return std::min(longest, *model_of(0).stages[first.stage.index].until.time / parts);
  Real stable = first.stable_dt;
  for (std::size_t k = 1; k < count(); ++k)
    if (!is_spring(k)) stable = std::min(stable, others_[k - 1]->stable_dt);
  return stable;
}

void CoupledLine::step(problem::State<2>& first, mpm::Workspace<2>& workspace, const std::function<void()>& step_first)
{
  find_time_steps(first, workspace);
  scale_springs(first);
  const Real dt = step_line(first, std::min(time_step(first), first.max_dt));
  slice_steps_ += std::count(is_spring_.begin(), is_spring_.end(), 0);
  if (of_case_.may_be_springs()) find_reactions_of_springs();
  std::string fault;
  noting(fault, [&] {
    for_each_task("slices", static_cast<Index>(count()), [&](Index k) {
      problem::State<2>& state = k == 0 ? first : *others_[k - 1];
      if (is_spring(static_cast<std::size_t>(k))) return step_as_spring(k, dt, state);
      if (!own(k)) return let_time_pass(dt, state);
      const mpm::Workspace<2>& work = k == 0 ? workspace : *workspaces_[k - 1];
      const Real limit = std::exchange(state.max_dt, dt);
      for_slice(k, [&] {
        drive(model_of(k), state, sideways_[k], upwards_[k]);
        if (k == 0) return step_first();
        take_step(model_of(k), state, *workspaces_[k - 1]);
        mpm::refuse_rigid_outside_mesh(model_of(k), state);
      });
      state.max_dt = limit;
      forces_[static_cast<std::size_t>(k)] = {state.rigid_bodies[0].reaction, mpm::contact_mass(work)};
    });
  });
  share_slices(first, fault);
}

void CoupledLine::lengthen(const CoupledLine& before, const settings::Case& c, const problem::State<2>& first,
                           const problem::State<2>& start)
{
  coupled_ = before.coupled_;
  if (!coupled_) return;
  make_others(first);
  begin_stage(first);
  state_ = before.state_;
  is_spring_ = before.is_spring_;
  slice_steps_ = before.slice_steps_;
  laid_embedment_ = before.laid_embedment_;
  forces_ = before.forces_;
  for (std::size_t s = 1; s < count(); ++s) {
    const problem::State<2>& laid = soils_[s].laid == nullptr ? start : *soils_[s].laid;
    *others_[s - 1] = problem::lengthen(c, before.model_of(s), before.slice(s), model_of(s), laid).state;
  }
  for (std::size_t s = 1; s < count(); ++s) mpm::set_inactive_cells(model_of(s), *others_[s - 1]);
  begin_soils();
}

void CoupledLine::archive(Archive& k, const problem::State<2>& first)
{
  k("coupled", coupled_);
  if (!coupled_) return;
  if (k.reads()) {
    make_others(first);
    begin_stage(first);
  }
  k.table("line", [&] { beam::archive(k, state_); });
  k.fixed("is_spring", is_spring_);
  k("slice_steps", slice_steps_);
  k("laid_embedment", laid_embedment_);
  for (std::size_t s = 0; s < count(); ++s)
    k.table(fmt::format("slice_{}", s), [&] {
      SliceForce& slice = forces_[s];
      static_assert(sizeof(slice) == 3 * sizeof(Real));
      k("force", slice.force);
      k("contact_mass", slice.contact_mass);
      if (s > 0) problem::archive(k, model_of(s), *others_[s - 1]);
    });
  if (!k.reads()) return;
  for (std::size_t s = 1; s < count(); ++s) mpm::set_inactive_cells(model_of(s), *others_[s - 1]);
  begin_soils();
}

}  // namespace berm::slices
