// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/simulate.hpp"

#include "core/error.hpp"
#include "core/for_each.hpp"
#include "core/interrupt.hpp"
#include "core/vector_unit.hpp"
#include "input/write_case.hpp"
#include "mpm/body_sums.hpp"
#include "mpm/condition.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/step.hpp"
#include "mpm/time_step.hpp"
#include "problem/archive_state.hpp"
#include "problem/stages.hpp"
#include "run_folder/frame_maker.hpp"
#include "run_folder/frames.hpp"
#include "run_folder/progress.hpp"
#include "simulation/checkpoints.hpp"
#include "simulation/memory.hpp"
#include "simulation/recorder.hpp"
#include "simulation/results.hpp"
#include "simulation/run_clock.hpp"
#include "simulation/scratch_folder.hpp"
#include "simulation/simulate_fem.hpp"
#include "simulation/with_run_folder.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <spdlog/spdlog.h>

namespace berm::simulation {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

Real expected_time(const problem::Case& c)
{
  Real total = 0;
  for (const problem::StageSettings& stage : c.stage) total += expected_time(stage);
  return total;
}

/// A thousandth of the time that the stages take, unless the user says.
Real history_interval(const problem::Case& c)
{
  if (c.output.history_time) return *c.output.history_time;
  for (const problem::StageSettings& stage : c.stage)
    if (expected_time(stage) <= 0)
      throw InputError(fmt::format("output.history_time: is needed, since it is not known how long stage \"{}\" takes", stage.name));
  return expected_time(c) / 1000;
}

template <int dim>
BigIndex particle_count(const problem::State<dim>& state)
{
  BigIndex count = 0;
  for (const bodies::Particles<dim>& particles : state.particles) count += particles.size();
  return count;
}

/// The run itself: steps, and what is written on the way.
template <int dim>
class Run {
public:
  Run(const RunRequest& request, problem::Problem<dim> problem, const run_folder::RunFolder& folder, run_folder::RunLog& log)
      : request_(request),
        folder_(folder),
        problem_(std::move(problem)),
        interval_(history_interval(request.settings)),
        checkpoints_(folder.path(), request.settings.output.checkpoint_wall_time),
        recorder_(model(), state()),
        frame_maker_(model(), state()),
        frames_(folder.subfolder("frames"), model().mesh),
        progress_(log)
  {
  }

  /// A run that fails leaves what it had: the results are written before the error goes on.
  bool to_the_end()
  {
    const bool at_start = begin();
    run_then_write_results(
        [&] {
          if (at_start) record(), frame();
          step_to_the_end();
        },
        [&] { leave_results(); });
    if (finished_) checkpoints_.remove();
    return finished_;
  }

private:
  void leave_results()
  {
    if (!finished_) frame();
    const run_folder::MpmCounts counts{particle_count(state())};
    const run_folder::RunTiming timing{clock_.wall(), request_.threads, model().mesh.cell_count(), state().step, counts, clock_.loops()};
    write_results(request_, folder_, model(), state().rigid_bodies, frames_.last(), {finished_, held_force_, checks()}, timing);
  }

  const problem::Model<dim>& model() const { return problem_.model; }
  problem::State<dim>& state() { return problem_.state; }
  const problem::StageSettings& stage() { return model().stages[state().stage.index]; }

  /// Begins at the start (true), or where the last checkpoint was written.
  bool begin()
  {
    const bool from_checkpoint = request_.resume && checkpoints_.read([&](Archive& k) { archive(k); });
    if (request_.resume && !from_checkpoint) spdlog::info("there is no checkpoint in {}: begins at the start", folder_.path().string());
    if (unit_ != vector_unit())
      spdlog::warn("the run was begun on the vector unit {}, and goes on with {}: results are the same but for round-off", unit_,
                   vector_unit());
    history_.emplace(history_path(), history_bytes_);
    if (request_.resume) frames_.remove_others();
    progress_.count_from(clock_.earlier());
    work_.emplace(model(), state());
    if (model().update_stress_first)
      spdlog::warn(
          "scheme = \"usf\" is there to compare with: a body that rests on soil under a load gains energy (docs/theory.md, section 4)");
    return !from_checkpoint;
  }

  void step_to_the_end()
  {
    bool stopped = false;
    while (!finished_ && !stopped) {
      step(model(), state(), *work_);
      mpm::refuse_rigid_outside_mesh(model(), state());
      const bool ended = stage_ended(model(), state());
      if (ended || state().time >= next_row_) record();
      if (ended || frame_is_due()) frame();
      if (ended || progress_.due()) tell();
      if (ended) next_stage();
      const bool asked_to_stop = interrupted();
      if (ended || asked_to_stop) checkpoints_.ask();
      if (finished_ || !at_checkpoint_boundary() || !checkpoints_.due()) continue;
      history_bytes_ = history_->sync();  // a history that the disk does not take ends the run, a checkpoint does not
      checkpoints_.write(state().step, [&](Archive& k) { archive(k); });
      stopped = asked_to_stop;
    }
    if (finished_) return;
    record();
    spdlog::warn("stopped at t = {:.6g} s in stage \"{}\"; what was computed until then is in {}. To go on: berm run --resume {}",
                 state().time, stage().name, folder_.path().string(), folder_.path().string());
  }

  /// The time step is chosen by the velocities of the nodes in the step before, which are no part of the state: not where it is due.
  bool at_checkpoint_boundary() { return state().step % mpm::steps_between_time_steps != 0; }

  fs::path history_path() const { return folder_.file("history.csv"); }

  /// All that a checkpoint holds. What must fit comes first.
  void archive(Archive& k)
  {
    archive_same(k, "case", input::resolved_toml(request_.settings), "it is of another case than resolved.toml");
    archive_same_mesh(k, model().mesh);
    k("vector_unit", unit_);
    k.table("history", [&] { archive_history(k, history_path(), history_bytes_); });
    k.table("frames", [&] { frames_.archive(k); });
    k.table("increments", [&] { frame_maker_.archive(k); });
    k.table("recorder", [&] { recorder_.archive(k); });
    k.table("clock", [&] { clock_.archive(k); });
    k("next_row", next_row_);
    k("frame_time", frame_time_);
    k("frame_displacement", frame_displacement_);
    k("equilibrium", equilibrium_);
    k("held_force", held_force_);
    k.table("state", [&] { problem::archive(k, model(), state()); });
  }

  void record()
  {
    recorder_.add_row(model(), state(), *work_, *history_);
    next_row_ = (std::floor(state().time / interval_ * (1 + 1e-12)) + 1) * interval_;
  }

  Real travel()
  {
    const Index driven = model().driven[state().stage.index];
    return driven == none ? 0 : (state().rigid_bodies[driven].displacement - frame_displacement_).norm();
  }
  bool frame_is_due()
  {
    const problem::OutputSettings& output = request_.settings.output;
    return (output.frame_time && state().time >= frame_time_ + *output.frame_time) ||
           (output.frame_travel && travel() >= *output.frame_travel);
  }
  void frame()
  {
    const Timer timer("write frames");
    frames_.write(frame_maker_.make(state()));
    ::malloc_trim(0);  // gives back what writing took on the way: a tenth of what the run has
    frame_time_ = state().time;
    const Index driven = model().driven[state().stage.index];
    if (driven != none) frame_displacement_ = state().rigid_bodies[driven].displacement;
  }

  void next_stage()
  {
    if (stage().kind == problem::StageKind::geostatic) {
      equilibrium_ = recorder_.out_of_balance();
      const char* verdict = equilibrium_ <= stage().equilibrium ? "in equilibrium" : "NOT in equilibrium";
      spdlog::info("stage \"{}\": the soil is {}: out-of-balance force over weight {:.3g}, accepted {:.3g}", stage().name, verdict,
                   equilibrium_, stage().equilibrium);
      if (equilibrium_ > stage().equilibrium) spdlog::warn("give stage \"{}\" more time or damping", stage().name);
    }
    if (state().stage.index + 1 == static_cast<Index>(model().stages.size())) {
      finished_ = true;
      return;
    }
    ++state().stage.index;
    begin_stage(model(), state());
    const bodies::Drive& vertical = state().stage.drive[model().axes.up];
    if (stage().kind == problem::StageKind::drag && vertical.by_force && !held_force_) held_force_ = -model().axes.sign * vertical.to;
  }

  /// The part of the run that is done, by the limits that the stages name.
  Real part_done()
  {
    Real passed = 0;
    for (Index k = 0; k < state().stage.index; ++k) passed += expected_time(model().stages[k]);
    const Real of_stage = expected_time(stage()), total = expected_time(request_.settings);
    if (!(of_stage > 0)) return std::numeric_limits<Real>::quiet_NaN();
    return std::min(Real(1), (passed + std::min(of_stage, state().time - state().stage.begin_time)) / total);
  }
  void tell()
  {
    run_folder::ProgressReport report;
    report.stage = stage().name;
    report.done = part_done();
    report.drag = stage().kind == problem::StageKind::drag;
    if (model().main_rigid != none) {
      const problem::PipeMotion motion = pipe_motion(model(), state(), model().main_rigid);
      report.u = motion.u;
      report.w = motion.w;
      report.V = recorder_.vertical();
      report.H = recorder_.horizontal();
      report.diameter = width_of<dim>(model().rigid_bodies[model().main_rigid].shape);
    }
    report.particle_steps = static_cast<Real>(particle_count(state()) * state().step);
    progress_.update(report);
  }

  /// What tells that the run can be trusted; what does not is a warning in the log, too.
  run_folder::Summary::Checks checks()
  {
    constexpr Real much_shaking = 0.15, much_mass = 0.01, much_work = 0.01;
    run_folder::Summary::Checks found = {{"energy_error", recorder_.energy_error()}};
    if (std::isfinite(equilibrium_)) found.emplace_back("out_of_balance_after_geostatic", equilibrium_);
    found.emplace_back("momentum_error", mpm::momentum_error(state()));
    found.emplace_back("friction_work_is_loss", state().totals.friction >= 0);
    if (std::isfinite(recorder_.shaking())) found.emplace_back("shaking_at_body", recorder_.shaking());
    const mpm::SoilCondition soil = mpm::soil_condition(model(), state());
    found.emplace_back("mass_at_min_volume", soil.at_min_volume);
    found.emplace_back("mass_at_max_volume", soil.at_max_volume);
    found.emplace_back("mass_in_the_air", soil.in_the_air);

    if (recorder_.shaking() > much_shaking)
      spdlog::warn("the soil at the rigid body shakes: unresolved motion makes {:.2g} of its pressure (above {:g} soil without cohesion "
                   "loses strength); "
                   "keep mpm.bulk_viscosity and mpm.velocity_filter at their defaults, or drive slower",
                   recorder_.shaking(), much_shaking);
    if (-state().totals.friction > much_work * recorder_.largest_work())
      spdlog::warn(
          "contact gave {:.2g} J instead of taking energy: use scheme = \"two_sided\" or a smaller mpm.courant, and let no rigid body "
          "scrape over a boundary that is held",
          -state().totals.friction);
    const auto warn_of_bound = [&](Real part, const char* which, const char* key, Real ratio) {
      if (part > much_mass)
        spdlog::warn("{:.2g} % of the soil is at its {} volume, {} of the first: change mpm.{} if it should go on", 100 * part, which,
                     ratio, key);
    };
    warn_of_bound(soil.at_min_volume, "smallest", "min_volume_ratio", model().mpm.min_volume_ratio);
    warn_of_bound(soil.at_max_volume, "largest", "max_volume_ratio", model().mpm.max_volume_ratio);
    if (soil.in_the_air > much_mass) spdlog::warn("{:.2g} % of the soil is in the air", 100 * soil.in_the_air);
    return found;
  }

  const RunRequest& request_;
  const run_folder::RunFolder& folder_;
  problem::Problem<dim> problem_;
  std::optional<mpm::Work<dim>> work_;  ///< made of the state that the run begins with or goes on from
  Real interval_;
  RunClock clock_;
  Checkpoints checkpoints_;
  std::optional<run_folder::HistoryFile> history_;
  BigIndex history_bytes_ = 0;  ///< when the last checkpoint was written or read
  Recorder<dim> recorder_;
  run_folder::FrameMaker<dim> frame_maker_;
  run_folder::FrameWriter<dim> frames_;
  run_folder::Progress progress_;
  bool finished_ = false;
  Real next_row_ = 0, frame_time_ = 0, equilibrium_ = std::numeric_limits<Real>::quiet_NaN();
  Vec<dim> frame_displacement_ = Vec<dim>::Zero();
  std::optional<Real> held_force_;
  std::string unit_ = vector_unit();  ///< that the run was begun on
};

/// Mesh files go to the scratch folder. A run that there is no memory for is refused as early as its size is known.
template <int dim>
problem::Problem<dim> build_for(const RunRequest& request, const ScratchFolder& scratch)
{
  history_interval(request.settings);  // refuses a case in which it cannot be told
  const problem::Case c = to_build(request);
  const Real in_use = memory_in_use();
  refuse_without_memory<dim>(min_size<dim>(c), in_use);
  mesh::Mesh<dim> mesh = make_mesh<dim>(c.mesh, request.case_file.parent_path().string(), scratch.path().string());
  refuse_without_memory<dim>(min_size(c, mesh), in_use);
  problem::Problem<dim> problem = build(c, std::move(mesh));
  refuse_without_memory<dim>(size_of(problem), in_use);
  ::malloc_trim(0);  // gives back what building took on the way: a fifth of what it made
  return problem;
}

template <int dim>
bool run_in(const RunRequest& request)
{
  const ScratchFolder scratch;
  problem::Problem<dim> problem = build_for<dim>(request, scratch);

  const std::string size = fmt::format("{} cells, {} particles", problem.model.mesh.cell_count(), particle_count(problem.state));
  return with_run_folder(request, scratch, size, [&](const run_folder::RunFolder& folder, run_folder::RunLog& log) {
    return Run<dim>(request, std::move(problem), folder, log).to_the_end();
  });
}

template <int dim>
void check_in(const RunRequest& request)
{
  const ScratchFolder scratch;
  const Real in_use = memory_in_use();
  problem::Problem<dim> problem = build_for<dim>(request, scratch);
  mpm::Work<dim> work(problem.model, problem.state);
  const Real dt = stable_time_step(problem.model, problem.state, work);
  fmt::print("{}\n", request.case_file.string());
  fmt::print("  cells        {}\n  nodes        {}\n", problem.model.mesh.cell_count(), problem.model.mesh.node_count());
  for (std::size_t b = 0; b < problem.model.bodies.size(); ++b)
    fmt::print("  particles    {} in body \"{}\"\n", problem.state.particles[b].size(), problem.model.bodies[b].name);
  fmt::print("  memory       about {:.0f} MiB at most, while frames are written\n",
             (in_use + memory_of<dim>(size_of(problem))) / (1 << 20));
  fmt::print("  time step    {:.4g} s\n", dt);

  // The speed is measured on the first steps, for a quarter of a second.
  const Clock::time_point start = Clock::now();
  Real wall = 0;
  while (wall < 0.25) {
    step(problem.model, problem.state, work);
    wall = std::chrono::duration<Real>(Clock::now() - start).count();
  }
  const Real seconds_a_step = wall / static_cast<Real>(problem.state.step);
  const Real total = expected_time(request.settings);
  for (const problem::StageSettings& stage : request.settings.stage)
    if (!(expected_time(stage) > 0))
      fmt::print("  stage \"{}\": its duration is not known in advance and is not counted below\n", stage.name);
  fmt::print("  steps        about {:.0f}, {} rows of history\n", total / dt,
             static_cast<BigIndex>(total / history_interval(request.settings)));
  fmt::print("  time         about {} with {} threads ({:.3g} million particle-steps/s)\n",
             run_folder::words_of_duration(total / dt * seconds_a_step), request.threads,
             static_cast<Real>(particle_count(problem.state)) / seconds_a_step / 1e6);
}

}  // namespace

bool run_case(const RunRequest& request)
{
  if (request.settings.method == problem::Method::fem) return run_fem(request);
  return request.settings.dimension == 2 ? run_in<2>(request) : run_in<3>(request);
}

void try_to_build(const RunRequest& request)
{
  if (request.settings.method == problem::Method::fem) return try_to_build_fem(request);
  const ScratchFolder scratch;
  if (request.settings.dimension == 2)
    build_for<2>(request, scratch);
  else
    build_for<3>(request, scratch);
}

void check_case(const RunRequest& request)
{
  if (request.settings.method == problem::Method::fem) return check_fem(request);
  request.settings.dimension == 2 ? check_in<2>(request) : check_in<3>(request);
}

}  // namespace berm::simulation
