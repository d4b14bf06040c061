// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/recorder.hpp"

#include "core/error.hpp"
#include "mpm/body_sums.hpp"
#include "mpm/condition.hpp"
#include "problem/archive_state.hpp"
#include "problem/stages.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();
constexpr const char* direction_names[3] = {"x", "y", "z"};
constexpr const char* component_names[6] = {"xx", "yy", "zz", "xy", "yz", "zx"};

}  // namespace

template <int dim>
std::vector<std::string> Recorder<dim>::columns(const problem::Model<dim>& model)
{
  std::vector<std::string> names = run_folder::common_columns();
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r)
    if (r != model.main_rigid)
      for (const char* column : {"u_m", "w_m", "H_N_m", "V_N_m", "M_Nm_m", "angle_rad"})
        names.push_back(fmt::format("{}_{}", model.rigid_bodies[r].name, column));
  for (const problem::Body<dim>& body : model.bodies) {
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_u{}_m", body.name, direction_names[d]));
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_v{}_m_s", body.name, direction_names[d]));
    for (int d = 0; d < dim; ++d)
      for (const char* end : {"min", "max"}) names.push_back(fmt::format("{}_{}{}_m", body.name, direction_names[d], end));
    for (int d = dim == 2 ? 2 : 0; d < 3; ++d) names.push_back(fmt::format("{}_L{}_N_s", body.name, direction_names[d]));
  }
  for (const problem::Contact& contact : model.contacts)
    for (int d = 0; d < dim && contact.other_body != none; ++d)
      names.push_back(fmt::format("{}_F{}_N_m", contact.name, direction_names[d]));
  for (const problem::Traction& traction : model.tractions) {
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_F{}_N_m", traction.name, direction_names[d]));
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_u{}_m", traction.name, direction_names[d]));
  }
  for (const problem::Watch& watch : model.watches) {
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_u{}_m", watch.name, direction_names[d]));
    for (int d = 0; d < dim; ++d) names.push_back(fmt::format("{}_v{}_m_s", watch.name, direction_names[d]));
    for (int k = 0; k < tensor_size<dim>; ++k) names.push_back(fmt::format("{}_s{}_Pa", watch.name, component_names[k]));
  }
  return names;
}

template <int dim>
Recorder<dim>::Recorder(const problem::Model<dim>& model, const problem::State<dim>& start)
    : last_time_(start.time),
      last_rigids_(start.rigid_bodies),
      last_pair_impulses_(start.pair_impulses)
{
  for (const bodies::Particles<dim>& particles : start.particles) {
    const mpm::BodySums<dim> sums = mpm::sums_over(particles);
    first_centers_.push_back(sums.center());
    first_kinetic_ += sums.kinetic;
  }
  first_loaded_ = start.load_points;
  for (const problem::Watch& watch : model.watches) first_watched_.push_back(mpm::particle_of(start.particles[watch.body], watch.id).x);
}

template <int dim>
void Recorder<dim>::archive(Archive& k)
{
  k("last_time", last_time_);
  for (std::size_t r = 0; r < last_rigids_.size(); ++r) k.table(fmt::format("rigid_{}", r), [&] { problem::archive(k, last_rigids_[r]); });
  for (std::size_t c = 0; c < last_pair_impulses_.size(); ++c) k(fmt::format("pair_impulse_{}", c), last_pair_impulses_[c]);
  k("vertical", vertical_);
  k("horizontal", horizontal_);
  k("out_of_balance", out_of_balance_);
  k("largest_error", largest_error_);
  k("largest_work", largest_work_);
  k("shaking", shaking_);
  k("shaken_rows", shaken_rows_);
}

template <int dim>
void Recorder<dim>::add_motion(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, std::vector<Real>& row)
{
  const problem::PipeMotion motion = pipe_motion(model, state, rigid);
  const Real time = state.time - last_time_;
  const Vec<dim> impulse = state.rigid_bodies[rigid].impulse - last_rigids_[rigid].impulse;
  const Vec<dim> reaction = time > 0 ? Vec<dim>(-impulse / time) : Vec<dim>(Vec<dim>::Zero());
  row.insert(row.end(), {motion.u, motion.w, -drag_direction(model, state) * reaction[0] + 0., reaction[1] + 0.});
}

template <int dim>
void Recorder<dim>::add_turn(const problem::State<dim>& state, Index rigid, std::vector<Real>& row)
{
  const Real time = state.time - last_time_, impulse = state.rigid_bodies[rigid].torque_impulse - last_rigids_[rigid].torque_impulse;
  row.insert(row.end(), {time > 0 ? -impulse / time + 0. : 0, state.rigid_bodies[rigid].angle});
}

template <int dim>
void Recorder<dim>::add_tractions(const problem::Model<dim>& model, const problem::State<dim>& state, std::vector<Real>& row) const
{
  for (Index t = 0; t < static_cast<Index>(model.tractions.size()); ++t) {
    Vec<dim> force = Vec<dim>::Zero(), moved_by = Vec<dim>::Zero();
    Real area = 0;
    for (std::size_t l = 0; l < model.load_points.size(); ++l) {
      const problem::LoadPoint<dim>& point = model.load_points[l];
      if (point.traction != t) continue;
      force += point.force;
      moved_by += point.area * (state.load_points[l].x - first_loaded_[l].x);
      area += point.area;
    }
    force *= part_of_traction(model.tractions[t], state.tractions[t], state.time);
    moved_by /= area;
    row.insert(row.end(), force.begin(), force.end());
    row.insert(row.end(), moved_by.begin(), moved_by.end());
  }
}

template <int dim>
void Recorder<dim>::add_row(const problem::Model<dim>& model, problem::State<dim>& state, const mpm::Work<dim>& work,
                            run_folder::HistoryFile& file)
{
  std::vector<Real> row;
  if (model.main_rigid != none)
    add_motion(model, state, model.main_rigid, row);
  else
    row.assign(4, unknown);
  horizontal_ = row[2];
  vertical_ = row[3];

  Real kinetic = 0;
  std::vector<mpm::BodySums<dim>> sums;
  for (const bodies::Particles<dim>& particles : state.particles) {
    sums.push_back(mpm::sums_over(particles));
    kinetic += sums.back().kinetic;
  }
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    if (model.rigid_bodies[r].motion == bodies::Motion::free) kinetic += kinetic_energy(model.rigid_bodies[r], state.rigid_bodies[r]);
  const problem::Totals<dim>& t = state.totals;
  const Real error = kinetic - first_kinetic_ + t.internal + t.damping + t.friction - t.external;
  if (!std::isfinite(error))
    throw RunError(fmt::format("energies are not finite at t = {} s (step {}); try a smaller mpm.courant (now {})", state.time, state.step,
                               model.mpm.courant));
  largest_error_ = std::max(largest_error_, std::abs(error));
  largest_work_ = std::max({largest_work_, std::abs(t.external), std::abs(t.internal), first_kinetic_});
  out_of_balance_ = work.weight > 0 ? work.unbalanced / work.weight : unknown;
  row.insert(row.end(), {kinetic, t.internal, t.damping, t.friction, t.external, error, out_of_balance_});

  if (model.main_rigid != none) {
    bodies::RigidState<dim>& now = state.rigid_bodies[model.main_rigid];
    const bodies::RigidState<dim>& last = last_rigids_[model.main_rigid];
    const Real pressed = now.impulse_sum - last.impulse_sum, time = state.time - last_time_;
    row.push_back(pressed > 0 ? (now.impulse_times_gap - last.impulse_times_gap) / pressed : unknown);
    row.push_back(now.max_overlap);
    row.push_back(time > 0 ? (now.second_impulse - last.second_impulse).norm() / time : 0);
    now.max_overlap = 0;
    add_turn(state, model.main_rigid, row);
  } else {
    row.insert(row.end(), 5, unknown);
  }
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r)
    if (r != model.main_rigid) {
      add_motion(model, state, r, row);
      add_turn(state, r, row);
    }
  for (std::size_t b = 0; b < sums.size(); ++b) {
    const Vec<dim> moved_by = sums[b].center() - first_centers_[b], velocity = sums[b].momentum / sums[b].mass;
    row.insert(row.end(), moved_by.begin(), moved_by.end());
    row.insert(row.end(), velocity.begin(), velocity.end());
    for (int d = 0; d < dim; ++d) row.insert(row.end(), {sums[b].lower[d], sums[b].upper[d]});
    const Vec<3> spin = sums[b].angular_momentum();
    row.insert(row.end(), dim == 2 ? spin.end() - 1 : spin.begin(), spin.end());
  }
  const Real time = state.time - last_time_;
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    for (int d = 0; d < dim && model.contacts[k].other_body != none; ++d)
      row.push_back(time > 0 ? (state.pair_impulses[k][d] - last_pair_impulses_[k][d]) / time : 0);
  add_tractions(model, state, row);
  for (std::size_t k = 0; k < model.watches.size(); ++k) {
    const bodies::Particle<dim> watched = mpm::particle_of(state.particles[model.watches[k].body], model.watches[k].id);
    const Vec<dim> moved_by = watched.x - first_watched_[k];
    row.insert(row.end(), moved_by.begin(), moved_by.end());
    row.insert(row.end(), watched.v.begin(), watched.v.end());
    row.insert(row.end(), watched.stress.c, watched.stress.c + tensor_size<dim>);
  }
  file.add(state.time, model.stages[state.stage.index].name, row);
  if (model.main_rigid != none && model.driven[state.stage.index] == model.main_rigid)
    if (const Real now = mpm::shaking(model, state, work); std::isfinite(now)) shaking_ += now, shaken_rows_ += 1;
  last_time_ = state.time;
  last_rigids_ = state.rigid_bodies;
  last_pair_impulses_ = state.pair_impulses;
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace berm::simulation
