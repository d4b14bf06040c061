// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/mpm_method.hpp"

#include "core/ranks.hpp"
#include "io/duration_text.hpp"
#include "io/log.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/inactive.hpp"
#include "mpm/step.hpp"
#include "mpm/time_step.hpp"
#include "os/error.hpp"
#include "problem/archive_state.hpp"
#include "problem/equilibrium.hpp"
#include "problem/lengthen.hpp"
#include "problem/safety.hpp"
#include "problem/stages.hpp"
#include "run_folder/checkpoint_file.hpp"
#include "run_folder/frames.hpp"
#include "settings/safety.hpp"
#include "settings/time_scale.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/history_interval.hpp"
#include "simulation/memory.hpp"
#include "simulation/processor_clock.hpp"
#include "simulation/run_place.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <malloc.h>

namespace berm::simulation {
namespace {

constexpr Real max_shaking = 0.15, max_mass = 0.01, max_contact_work = 0.01, max_stopped = 0.01;  // above them a warning
constexpr Real max_beyond_force = 0.02;                                                           // of a limit of force, likewise

constexpr BigIndex steps_between_looks = 16;  // at all particles
constexpr Real at_rest_in_period = 1e-3;      // of the displacement of failure: what soil at rest may drift by in a period

/// Mesh files go to the scratch folder. A run that there is no memory for is refused as early as its size is known.
template <int dim>
problem::Problem<dim> build_for(const RunRequest& request, const io::ScratchFolder& scratch)
{
  history_interval_of(request.settings);  // refuses a case in which it is not known
  const settings::Case c = case_to_run(request);
  const Real in_use = memory_in_use();
  refuse_without_memory<dim>(min_size<dim>(c), in_use);
  refuse_without_memory_for_gmsh(c);
  mesh::Mesh<dim> mesh = make_mesh<dim>(c.mesh, request.case_file.parent_path().string(), scratch.path().string());
  refuse_without_memory<dim>(min_size(c, mesh), in_use);
  problem::Problem<dim> problem = problem::build(c, std::move(mesh));
  refuse_without_memory<dim>(size_of(problem), in_use);
  ::malloc_trim(0);  // gives back what building took on the way: a fifth of what it made
  return problem;
}

}  // namespace

template <int d>
MpmMethod<d>::MpmMethod(const RunRequest& request, const io::ScratchFolder& scratch)
    : memory_before_(memory_in_use()),
      case_(request.settings),
      problem_(build_for<d>(request, scratch)),
      history_interval_(history_interval_of(request.settings)),
      recorder_(request.settings, model(), state()),
      frame_maker_(model(), state())
{
  for (const bodies::Particles<d>& particles : state().particles) counts_.particles += particles.size();
  if (case_.safety) begin_trial();
}

template <int d>
void MpmMethod<d>::begin_trial()
{
  if (Ranks::of_run().count() > 1) throw InputError("a trial of the factor of safety is run by one process: start it without the launcher");
  std::vector<Vec<d>> corners;
  for (const bodies::Particles<d>& particles : state().particles)
    for (const Index cell : particles.occupied())
      for (const Index node : model().mesh.nodes[cell]) corners.push_back(model().mesh.position[node]);
  const Real depth = depth_of_soil(model(), corners);
  trial_.emplace(movement_at_failure(case_, model(), depth), time_factor_of_last_stage(case_, depth));
  trial_->begin_stage(!moves_body(model().stages.front()));
  places_.note(state());
  drift_ = WindowMeans(model().longest_period);
}

template <int d>
MpmMethod<d>::~MpmMethod()
{
  Ranks::of_run().unite();
}

template <int d>
run_folder::Frame<d> MpmMethod<d>::make_frame(run_folder::Frame<d> old)
{
  const mpm::WholeState<d> whole = whole_state();
  return Ranks::of_run().is_first() ? frame_maker_.make(state(), std::move(old)) : run_folder::Frame<d>();
}

template <int d>
std::string MpmMethod<d>::size_words() const
{
  return fmt::format("{} cells, {} particles", model().mesh.cell_count(), counts().particles);
}

/// Each rank reads the case and makes the mesh for itself.
template <int d>
void MpmMethod<d>::refuse_other_problem() const
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  const mesh::Mesh<d>& mesh = model().mesh;
  const std::vector<std::uint32_t> own = {
      run_folder::crc_of(mesh.position.data(), sizeof(Vec<d>) * static_cast<std::size_t>(mesh.node_count())),
      run_folder::crc_of(mesh.nodes.data(), sizeof(mesh.nodes[0]) * static_cast<std::size_t>(mesh.cell_count())),
      static_cast<std::uint32_t>(counts_.particles)};
  std::vector<std::uint32_t> all;
  ranks.gather_from_all(own, all);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k] != all[k % own.size()])
      throw RunError(fmt::format(
          "rank {} has another mesh or other particles than rank 0: do all machines have the same case, build and Gmsh?", k / own.size()));
}

template <int d>
void MpmMethod<d>::begin(bool)
{
  before_ = nullptr;
  own_before_.reset();
  start_.reset();
  refuse_other_problem();
  mpm::set_inactive_cells(model(), problem_.state);
  if (!case_.pipeline) mpm::divide(model(), problem_.state);  // of a pipeline ranks have whole slices
  workspace_.emplace(model(), state());
  if (model().update_stress_first)
    io::warn("scheme = \"usf\" is for comparison only: a body that rests on soil under a load gains energy "
             "(docs/theory/soil_and_contact.md, Schemes)");
}

template <int d>
void MpmMethod<d>::step()
{
  if (Ranks::of_run().divided()) divide_anew();
  soil_changed_ = state().step % mpm::steps_between_time_steps == 0 && change_soil();
  mpm::step(model(), problem_.state, *workspace_);
  recorder_.observe_step(model(), *workspace_);
  if (trial_ && state().step % steps_between_looks == 0) {
    trial_->note(places_.largest_movement(state()));
    drift_.note(state().time - state().stage.begin_time, trial_->movement());
  }
  mpm::refuse_rigid_outside_mesh(model(), state());
}

/// Fills and excavations, where the time step is due: it depends on the soil.
template <int d>
bool MpmMethod<d>::change_soil()
{
  const std::vector<problem::EarthworkState<d>> before = state().earthworks;
  if (!carry_out_earthworks(model(), problem_.state)) return false;
  for (std::size_t b = 0; b < state().particles.size(); ++b)
    if (!Ranks::of_run().any(state().particles[b].size() > 0))
      throw RunError(fmt::format("body \"{}\" has no soil left after its excavations at t = {:.4g} s: excavate less",
                                 model().bodies[b].name, state().time));
  workspace_.emplace(model(), state());
  for (std::size_t k = 0; k < before.size(); ++k) {
    const problem::Earthwork<d>& work = model().earthworks[k];
    const problem::EarthworkState<d>& now = state().earthworks[k];
    if (now.lifts == before[k].lifts) continue;
    const std::string named = fmt::format("{} \"{}\"{}", work.fills ? "fill" : "excavation", work.name,
                                          work.lifts > 1 ? fmt::format(", lift {} of {}", now.lifts, work.lifts) : "");
    const BigIndex particles = now.particles - before[k].particles;
    const bool whole = d == 3 || model().mesh.metric == mesh::Metric::axisymmetric;
    const char* kilograms = whole ? "kg" : "kg/m";
    const Real mass = model().parts * (now.mass - before[k].mass), volume = model().parts * (now.volume - before[k].volume);
    io::info("{}: {} particles, {:.4g} {} in {:.4g} {} {} at t = {:.4g} s", named, particles, mass, kilograms, volume, whole ? "m3" : "m2",
             work.fills ? "placed" : "taken out", state().time);
    if (particles == 0)
      io::warn("{}: {}", named,
               work.fills
                   ? "there is no room for a particle in its area: soil or rigid bodies fill it, or it is thinner than a row of particles"
                   : "there is no soil of its body in its area");
    if (!work.fills || now.lifts < work.lifts) continue;
    constexpr Real too_far = 0.02;
    const Real placed = model().parts * now.mass, room = model().parts * mass_of_room(model(), work, now);
    io::info("fill \"{}\": {:.4g} {} placed in total, and its area would hold {:.4g} {}", work.name, placed, kilograms, room, kilograms);
    if (std::abs(placed - room) > too_far * room)
      io::warn("fill \"{}\" has {:.2g} % {} mass than its area would hold: take lifts that are thicker than a row of particles, or "
               "smaller cells",
               work.name, 100 * std::abs(placed / room - 1), placed < room ? "less" : "more");
  }
  return true;
}

/// Where some ranks wait for others: soon after the start, then less and less often. Not where the time step is due, as with a checkpoint.
template <int d>
void MpmMethod<d>::divide_anew()
{
  constexpr BigIndex first = mpm::steps_between_time_steps, offset = first / 2, longest = 1024;
  if (next_division_ == 0) {
    next_division_ = state().step / first * first + first + offset;
    steps_between_divisions_ = first;
  }
  if (state().step != next_division_) return;
  next_division_ += steps_between_divisions_;
  steps_between_divisions_ = std::min(2 * steps_between_divisions_, longest);
  const auto now = std::chrono::steady_clock::now();
  const Real waited = Ranks::of_run().messenger()->traffic().seconds;
  const Real busy = std::chrono::duration<Real>(now - measured_since_).count() - (waited - waited_);
  const bool measured = measured_since_.time_since_epoch().count() > 0;
  measured_since_ = now;
  waited_ = waited;
  if (measured && mpm::divide_anew(model(), problem_.state, busy)) workspace_.emplace(model(), state());
}

template <int d>
mpm::WholeState<d> MpmMethod<d>::whole_state()
{
  measured_since_ = {};  // what follows is done by the first rank alone
  return mpm::WholeState<d>(problem_.state);
}

template <int d>
void MpmMethod<d>::add_row(run_folder::HistoryFile& file, const MoreColumns& more)
{
  if (trial_) {
    trial_->note(places_.largest_movement(state()));
    recorder_.note_movement(trial_->movement());
  }
  recorder_.add_row(model(), state(), *workspace_, file, more);
  cells_.observe(model(), state());
}

template <int d>
sanity::Scene MpmMethod<d>::scene(const RunRequest& request, int threads)
{
  constexpr Real of_a_thread = d == 2 ? 15e6 : 4e6;  // particle-steps/s, of a usual machine
  sanity::Cost cost;
  try {
    cost.time_step = stable_time_steps(model(), state(), mpm::Workspace<d>(model(), state())).stable;
  } catch (const RunError&) {
    cost.time_step = 0;  // the run says why there is none
  }
  cost.particles = std::max(slices_, Real(1)) * static_cast<Real>(counts().particles);
  for (const bodies::Particles<d>& particles : state().particles)
    cost.frame_bytes +=
        static_cast<Real>(particles.size()) * static_cast<Real>(run_folder::bytes_of_point_in_file<d>(particles.extra_size()));
  cost.free_bytes = free_disk(request.folder);
  cost.particle_steps_per_s = of_a_thread * threads;
  return sanity::scene_of(request.settings, request.places, model(), state().particles, state().load_points, cost);
}

template <int d>
bool MpmMethod<d>::is_at_rest() const
{
  Real fastest = 0;
  for (const bodies::Particles<d>& particles : state().particles) fastest = std::max(fastest, mpm::sums_over(particles).fastest);
  return fastest <= velocity_at_rest(model(), model().stages[state().stage.index]);
}

template <int d>
bool MpmMethod<d>::stage_ended() const
{
  if (problem::stage_ended(model(), state()) || (trial_ && trial_->failed())) return true;
  return state().step % steps_between_looks == 0 && workspace_->weight > 0 &&
         in_balance(model(), state(), workspace_->unbalanced / workspace_->weight) && is_at_rest();
}

template <int d>
void MpmMethod<d>::log_equilibrium(const settings::StageSettings& stage) const
{
  const bool at_rest = !ends_at_equilibrium(stage) || is_at_rest();
  const char* verdict = equilibrium_ <= stage.equilibrium && at_rest ? "in equilibrium" : "NOT in equilibrium";
  io::info("stage \"{}\": after {:.3g} s the soil is {}: out-of-balance force / weight {:.3g}, accepted {:.3g}", stage.name,
           state().time - state().stage.begin_time, verdict, equilibrium_, stage.equilibrium);
  if (ends_at_equilibrium(stage) && !(equilibrium_ <= stage.equilibrium && at_rest))
    io::warn(
        "stage \"{}\" did not reach equilibrium in {:.3g} s, long enough for waves and damping: {}; where soil slides, the slope is too "
        "steep for its strength: flatten the ground or strengthen the soil; else give the stage damping = 0.7, or more time by until.time",
        stage.name, state().time - state().stage.begin_time, at_rest ? "forces are out of balance" : "the soil moves");
  else if (equilibrium_ > stage.equilibrium)
    io::warn("give stage \"{}\" more time or damping", stage.name);
}

template <int d>
void MpmMethod<d>::zero_displacements()
{
  recorder_.zero_displacements(model(), state());
  const mpm::WholeState<d> whole = whole_state();
  if (Ranks::of_run().is_first()) frame_maker_.zero_displacements(state());
}

template <int d>
bool MpmMethod<d>::next_stage()
{
  const settings::StageSettings& stage = model().stages[state().stage.index];
  if (stage.kind == settings::StageKind::geostatic && !(trial_ && trial_->failed())) {
    equilibrium_ = recorder_.out_of_balance();
    log_equilibrium(stage);
  }
  log_force_limit(stage);
  if (trial_) end_stage_of_trial();
  if (is_last_stage() || (trial_ && trial_->failed())) return false;
  enter_next_stage();
  return true;
}

template <int d>
void MpmMethod<d>::enter_next_stage()
{
  ++problem_.state.stage.index;
  if (model().stages[state().stage.index].zero_displacements) zero_displacements();
  begin_stage(model(), problem_.state);
}

template <int d>
void MpmMethod<d>::step_to(settings::StageKind kind)
{
  begin(true);
  while (model().stages[state().stage.index].kind != kind) {
    step();
    if (stage_ended()) enter_next_stage();
  }
}

template <int d>
bool MpmMethod<d>::is_last_stage() const
{
  return state().stage.index + 1 == static_cast<Index>(model().stages.size());
}

/// What a body has moved counts no more.
template <int d>
void MpmMethod<d>::end_stage_of_trial()
{
  if (is_last_stage()) trial_->end(is_at_rest() || drift_.drift() <= at_rest_in_period * trial_->limit());
  if (is_last_stage() || trial_->failed()) return io::info("{}", trial_->words(case_.safety->factor));
  if (moves_body(model().stages[state().stage.index])) places_.note(state());
  trial_->begin_stage(!moves_body(model().stages[state().stage.index + 1]));
}

/// How near to its limit of force the stage has ended that is over, by the last row of the history.
template <int d>
void MpmMethod<d>::log_force_limit(const settings::StageSettings& stage)
{
  const bool of_main = model().driven[state().stage.index] == model().main_rigid;
  if (!of_main || !std::isfinite(problem::beyond_force_limit(model(), state()))) return;
  const Real force =
      stage.kind == settings::StageKind::push ? recorder_.vertical() : drag_direction(model(), state()) * recorder_.horizontal();
  const Real beyond = std::abs(force / (model().parts * *stage.until.force) - 1);
  beyond_force_limit_ = std::isfinite(beyond_force_limit_) ? std::max(beyond_force_limit_, beyond) : beyond;
  io::info("stage \"{}\" ended {:.2g} % from its limit of force", stage.name, 100 * beyond);
  if (beyond > max_beyond_force)
    io::warn("stage \"{}\" ended {:.2g} % from its limit of force: drive slower, or push by a force", stage.name, 100 * beyond);
}

template <int d>
bool MpmMethod<d>::at_checkpoint_boundary() const
{
  return state().stable_dt_holds;
}

template <int d>
void MpmMethod<d>::come_to_checkpoint_boundary()
{
  if (at_checkpoint_boundary()) return;
  if (!model().earthworks.empty()) throw RunError("earthworks may be due now: step once more");
  find_stable_time_step(problem_.model, problem_.state, *workspace_);
}

template <int d>
void MpmMethod<d>::drive(int freedom, bool by_force, Real value)
{
  drive_otherwise(problem_.model, problem_.state, freedom, by_force, value);
}

template <int d>
void MpmMethod<d>::limit_time_step(Real dt)
{
  problem_.state.max_dt = dt;
}

template <int d>
void MpmMethod<d>::archive(Archive& k)
{
  MpmMethod& of = before_ != nullptr && k.reads() ? *before_ : *this;
  k.table("state", [&] { problem::archive(k, of.model(), of.problem_.state); });
  k.table("increments", [&] { of.frame_maker_.archive(k, of.state().lengthened); });
  if (&of != this) take_from_shorter();
  k.table("recorder", [&] { recorder_.archive(k); });
  k.table("cells", [&] { cells_.archive(k); });
  k("equilibrium", equilibrium_);
  if (std::any_of(model().stages.begin(), model().stages.end(), [](const auto& stage) { return stage.until.force.has_value(); }))
    k("beyond_force_limit", beyond_force_limit_);
  if (trial_)
    k.table("trial", [&] {
      trial_->archive(k);
      drift_.archive(k);
      places_.archive(k);
    });
  if (!state().lengthened) return;
  counts_.particles = 0;
  for (const bodies::Particles<d>& particles : state().particles) counts_.particles += particles.size();
}

template <int d>
void MpmMethod<d>::lengthen(MpmMethod& before)
{
  const std::string obstacle = trial_ ? "safety: a trial of the factor of safety" : problem::not_to_lengthen(model());
  if (!obstacle.empty()) throw KeyError(fmt::format("{} cannot be carried to a longer mesh: begin a new run on it", obstacle));
  before_ = &before;
  start_ = state();
}

template <int d>
void MpmMethod<d>::lengthen(std::unique_ptr<MpmMethod> before)
{
  own_before_ = std::move(before);
  lengthen(*own_before_);
}

template <int d>
Sides MpmMethod<d>::sides() const
{
  const bodies::RigidBody<d>& body = model().rigid_bodies[model().main_rigid];
  const Real half = width_of<d>(body.shape) / 2, first = center_of<d>(body.shape)[0],
             now = first + state().rigid_bodies[model().main_rigid].displacement[0];
  return {{first - half, first + half}, {now - half, now + half}};
}

template <int d>
void MpmMethod<d>::take_from_shorter()
{
  problem::LengthenedBed<d> bed = problem::lengthen(case_, before_->model(), before_->state(), model(), *start_);
  frame_maker_.lengthen(before_->frame_maker_, bed);
  problem_.state = std::move(bed.state);
}

template <int d>
run_folder::Summary::Checks MpmMethod<d>::checks() const
{
  run_folder::Summary::Checks checks = {{"energy_error", recorder_.energy_error()}};
  if (recorder_.largest_work() > 0) {
    checks.emplace_back("filter_over_work", state().ledger.totals.filter / recorder_.largest_work());
    checks.emplace_back("viscosity_over_work", state().ledger.totals.viscosity / recorder_.largest_work());
  }
  if (std::isfinite(equilibrium_)) checks.emplace_back("out_of_balance_after_geostatic", equilibrium_);
  if (std::isfinite(beyond_force_limit_)) checks.emplace_back("beyond_force_limit", beyond_force_limit_);
  checks.emplace_back("momentum_error", mpm::momentum_error(state(), model().mesh.metric));
  checks.emplace_back("friction_work_is_loss", state().ledger.totals.friction >= 0);
  if (std::isfinite(recorder_.shaking())) checks.emplace_back("shaking_at_body", recorder_.shaking());
  const mpm::SoilCondition soil = mpm::soil_condition(model(), state());
  if (model().mpm.active_distance) checks.emplace_back("energy_of_soil_that_came_to_rest", stopped_over_work());
  checks.emplace_back("mass_at_min_volume", soil.at_min_volume);
  checks.emplace_back("mass_at_max_volume", soil.at_max_volume);
  checks.emplace_back("mass_in_the_air", soil.in_the_air);
  if (trial_)
    for (auto& check : trial_->checks()) checks.push_back(std::move(check));
  const run_folder::Summary::Checks of_cells = cells_.checks();
  checks.insert(checks.end(), of_cells.begin(), of_cells.end());
  if (const Index main = model().main_rigid; main != none)
    cells_.warn(model().rigid_bodies[main].name, width_of<d>(model().rigid_bodies[main].shape));
  warn_of(soil);
  return checks;
}

/// Kinetic energy of soil that still moved when it came to rest, over the largest work so far.
template <int d>
Real MpmMethod<d>::stopped_over_work() const
{
  const Real work = recorder_.largest_work();
  return work > 0 ? state().active_soil.stopped / work : 0;
}

template <int d>
void MpmMethod<d>::warn_of(const mpm::SoilCondition& soil) const
{
  if (recorder_.shaking() > max_shaking)
    io::warn("the soil at the rigid body vibrates: unresolved motion is {:.2g} of its pressure (above {:g} soil without cohesion loses "
             "strength); "
             "keep mpm.bulk_viscosity and mpm.velocity_filter at their defaults, or drive slower",
             recorder_.shaking(), max_shaking);
  if (-state().ledger.totals.friction > max_contact_work * recorder_.largest_work()) {
    const bool coupled = std::all_of(model().contacts.begin(), model().contacts.end(),
                                     [](const auto& contact) { return contact.scheme == contact::Scheme::musl_coupled; });
    io::warn("contact added {:.2g} J instead of dissipating energy: use {}{}, and keep rigid bodies off boundaries that are fixed",
             -state().ledger.totals.friction, coupled ? "" : "scheme = \"musl_coupled\" or ", mpm::smaller_step(model().mpm));
  }
  if (model().mpm.active_distance && stopped_over_work() > max_stopped)
    io::warn("soil was still moving when it became inactive: {:.2g} of the work; enlarge mpm.active_distance (now {:g} m)",
             stopped_over_work(), *model().mpm.active_distance);
  const auto warn_of_bound = [&](Real part, const char* which, const char* key, Real ratio) {
    if (part > max_mass)
      io::warn("{:.2g} % of the soil is at its {} volume, {} of the initial one: change mpm.{} if it should change further", 100 * part,
               which, ratio, key);
  };
  warn_of_bound(soil.at_min_volume, "smallest", "min_volume_ratio", model().mpm.min_volume_ratio);
  warn_of_bound(soil.at_max_volume, "largest", "max_volume_ratio", model().mpm.max_volume_ratio);
  if (soil.in_the_air > max_mass) io::warn("{:.2g} % of the soil has been thrown up above the seabed", 100 * soil.in_the_air);
}

template <int d>
Estimate MpmMethod<d>::estimate(const Context& context)
{
  const Real total = expected_time(model().stages);
  const Pace pace = measure_pace();
  Estimate e;
  e.cells = model().mesh.cell_count();
  e.nodes = model().mesh.node_count();
  e.memory = memory_before_ + std::max(memory_of<d>(size_of(problem_)) + memory_of_slices_, memory_of_gmsh(case_));
  const Real time = expected_steps_time() / pace.dt * pace.seconds_a_step;
  if (total > 0) e.time = time;
  const auto say = [&]<class... Parts>(fmt::format_string<Parts...> format, Parts&&... parts) {
    e.lines.push_back(fmt::format(format, std::forward<Parts>(parts)...));
  };
  say("cells        {}", e.cells);
  say("nodes        {}", e.nodes);
  for (std::size_t b = 0; b < model().bodies.size(); ++b) {
    e.particles += state().particles[b].size();
    say("particles    {} in body \"{}\"", state().particles[b].size(), model().bodies[b].name);
  }
  say("memory       about {:.0f} MiB at most", e.memory / (1 << 20));
  say("time step    {:.4g} s", pace.dt);
  for (const settings::StageSettings& stage : model().stages)
    if (!(expected_time(stage) > 0)) say("stage \"{}\": its duration is not known in advance and is not counted below", stage.name);
  for (const std::string& line : load_history_lines()) e.lines.push_back(line);
  say("steps        about {:.0f}, {} rows of history", total / pace.dt, static_cast<BigIndex>(total / history_interval()));
  say("time         about {} with {} of a free machine ({:.3g} million particle-steps/s)", io::duration_text(time),
      words_of_workers(context), static_cast<Real>(counts().particles) / pace.seconds_a_step / 1e6);
  return e;
}

/// How fast load histories of forces run, and what automatic takes.
template <int d>
std::vector<std::string> MpmMethod<d>::load_history_lines() const
{
  std::vector<std::string> lines;
  for (const settings::StageSettings& stage : case_.stage)
    if (const std::optional<settings::TimeScale> slow = time_scale_of(case_, stage)) {
      lines.push_back(fmt::format("load history of stage \"{}\": {}; automatic is {:.3g}: half waves of {:.3g} s in {:.3g} s, by {}",
                                  stage.name, time_scale_words(stage), slow->scale, slow->half_wave, slow->half_wave * slow->scale,
                                  words_of(slow->reason)));
      if (stage.time_scale < 1)
        lines.push_back(fmt::format("             that is for a body that does not break out; {}: then run with time_scale = 1",
                                    settings::breakout_takes_time));
    }
  return lines;
}

template <int d>
Real MpmMethod<d>::expected_wall_time()
{
  const Real total = expected_time(model().stages);
  if (!(total > 0)) return nan;
  const Pace pace = measure_pace();
  return expected_steps_time() / pace.dt * pace.seconds_a_step;
}

/// The time that all stages are expected to take, s, as often as there are problems to step.
template <int d>
Real MpmMethod<d>::expected_steps_time() const
{
  Real sum = 0;
  for (const settings::StageSettings& stage : model().stages)
    sum += expected_time(stage) * (stage.kind == settings::StageKind::pipeline ? slices_ : 1);
  return sum;
}

template <int d>
typename MpmMethod<d>::Pace MpmMethod<d>::measure_pace()
{
  if (!case_.pipeline) mpm::divide(model(), problem_.state);  // of a pipeline ranks have whole slices
  mpm::Workspace<d>& workspace = workspace_.emplace(model(), state());
  const Real dt = stable_time_steps(model(), problem_.state, workspace).stable, total = expected_time(model().stages);
  const auto goes_on = [&] { return total <= 0 || state().time < total; };
  const ProcessorClock clock;
  Real least = infinity;
  for (Real now = 0; now < 0.25 && goes_on();) {
    const Real begin = now;
    const BigIndex first = state().step;
    while (now < begin + 0.02 && goes_on()) {
      step();
      now = Ranks::of_run().largest(clock.passed());
    }
    least = std::min(least, (now - begin) / static_cast<Real>(state().step - first));
  }
  return {dt, least};
}

template class MpmMethod<2>;
template class MpmMethod<3>;

}  // namespace berm::simulation
