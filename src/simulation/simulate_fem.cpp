// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_fem_test.cpp
#include "simulation/simulate_fem.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "fem/load_steps.hpp"
#include "problem/stages.hpp"
#include "run_folder/fem_frame.hpp"
#include "run_folder/frames.hpp"
#include "run_folder/progress.hpp"
#include "simulation/checkpoints.hpp"
#include "simulation/fem_recorder.hpp"
#include "simulation/memory.hpp"
#include "simulation/results.hpp"
#include "simulation/scratch_folder.hpp"
#include "simulation/with_run_folder.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace berm::simulation {
namespace {

using Clock = std::chrono::steady_clock;

Real seconds_since(Clock::time_point start)
{
  return std::chrono::duration<Real>(Clock::now() - start).count();
}

std::string words_of(const fem::FemModel& model)
{
  return fmt::format("{} elements, {} nodes", model.mesh.cell_count(), model.mesh.node_count());
}

/// Of what plastic flow dissipates: twice what the passes of an increment leave (LoadSteps).
constexpr Real much_lag = 0.02;

constexpr const char* larger_elements = "take larger elements";

/// The run itself: increments, and what is written on the way.
class FemRun {
public:
  FemRun(const RunRequest& request, fem::FemProblem problem, const run_folder::RunFolder& folder, run_folder::RunLog& log)
      : request_(request),
        folder_(folder),
        problem_(std::move(problem)),
        steps_(model(), state()),
        recorder_(folder.file("history.csv")),
        frame_maker_(model()),
        frames_(folder.subfolder("frames"), model().model.mesh),
        progress_(log)
  {
    refuse_without_memory(steps_.memory_to_come(), memory_in_use(), words_of(problem_.model), larger_elements);
  }

  /// A run that fails leaves what it had: the results are written before the error goes on.
  bool to_the_end()
  {
    reset_timings();
    const Clock::time_point start = Clock::now();
    run_then_write_results([&] { step_to_the_end(); }, [&] { leave_results(start); });
    if (finished_) Checkpoints(folder_.path(), 0).remove();
    return finished_;
  }

private:
  void leave_results(Clock::time_point start)
  {
    frame();
    if (recorder_.strength_lag() > much_lag)
      spdlog::warn(
          "the strength of the soil lags behind its pressure by {:.2g} of what its flow dissipates, and forces may be off by as much; "
          "compare a run with a tenth of fem.largest_step",
          recorder_.strength_lag());
    const run_folder::RunTiming timing{seconds_since(start),
                                       request_.threads,
                                       model().mesh.cell_count(),
                                       state().state.step,
                                       run_folder::FemCounts{model().mesh.node_count(), iterations_},
                                       timings()};
    const run_folder::Summary::Checks checks = {{"energy_error", recorder_.energy_error()},
                                                {"largest_unbalance", recorder_.largest_unbalance()},
                                                {"loose_increments", static_cast<Real>(accepted_above_tolerance_)},
                                                {"largest_overstress", recorder_.largest_overstress()},
                                                {"strength_lag", recorder_.strength_lag()},
                                                {"friction_work_is_loss", state().state.totals.friction >= 0}};
    write_results(request_, folder_, model().model, state().state.rigid_bodies, frames_.last(), {finished_, held_force_, checks}, timing);
  }

  const fem::FemModel& model() const { return problem_.model; }
  fem::FemState& state() { return problem_.state; }
  const problem::StageSettings& stage() { return model().model.stages[state().state.stage.index]; }

  void step_to_the_end()
  {
    if (request_.resume) {
      spdlog::info("a run of finite elements begins again at the start");
      frames_.remove_others();
    }
    steps_.settle();
    recorder_.add_row(model(), state(), {true, 0, 0, {}});
    frame();
    while (!interrupted() && !finished_) {
      const fem::IncrementEnd end = steps_.advance();
      iterations_ += end.iterations;
      if (!end.converged) {
        ++accepted_above_tolerance_;
        spdlog::warn("t = {:.6g} s: the increment is loosely converged only, with unbalanced forces of {:.2g} of the contact forces",
                     state().state.time, end.unbalance);
      }
      recorder_.add_row(model(), state(), end);
      const bool ended = stage_ended(model().model, state().state);
      if (ended || frame_is_due()) frame();
      if (ended || progress_.due()) tell();
      if (ended) next_stage();
    }
    if (!finished_)
      spdlog::warn("stopped at t = {:.6g} s in stage \"{}\"; what was computed until then is in {}. To begin again: berm run --resume {}",
                   state().state.time, stage().name, folder_.path().string(), folder_.path().string());
  }

  bool frame_is_due()
  {
    const problem::OutputSettings& output = request_.settings.output;
    const Real travel = model().rigid == none ? 0 : (state().state.rigid_bodies[model().rigid].displacement - frame_displacement_).norm();
    return (output.frame_time && state().state.time >= frame_time_ + *output.frame_time) ||
           (output.frame_travel && travel >= *output.frame_travel);
  }
  void frame()
  {
    if (!frames_.times().empty() && state().state.time == frame_time_) return;
    frames_.write(frame_maker_.make(state()));
    frame_time_ = state().state.time;
    if (model().rigid != none) frame_displacement_ = state().state.rigid_bodies[model().rigid].displacement;
  }

  void next_stage()
  {
    finished_ = !steps_.next_stage();
    if (finished_) return;
    const bodies::Drive& vertical = state().state.stage.drive[1];
    if (stage().kind == problem::StageKind::drag && vertical.by_force && !held_force_) held_force_ = -vertical.to;
  }

  void tell()
  {
    run_folder::ProgressReport report;
    report.stage = stage().name;
    report.done = std::numeric_limits<Real>::quiet_NaN();
    report.drag = stage().kind == problem::StageKind::drag;
    if (model().rigid != none) {
      const problem::PipeMotion motion = pipe_motion(model().model, state().state, model().rigid);
      report.u = motion.u;
      report.w = motion.w;
      report.V = recorder_.vertical();
      report.H = recorder_.horizontal();
      report.diameter = model().width;
    }
    progress_.update(report);
  }

  const RunRequest& request_;
  const run_folder::RunFolder& folder_;
  fem::FemProblem problem_;
  fem::LoadSteps steps_;
  FemRecorder recorder_;
  run_folder::FemFrameMaker frame_maker_;
  run_folder::FrameWriter<2> frames_;
  run_folder::Progress progress_;
  bool finished_ = false;
  BigIndex iterations_ = 0, accepted_above_tolerance_ = 0;
  Real frame_time_ = 0;
  Vec<2> frame_displacement_ = Vec<2>::Zero();
  std::optional<Real> held_force_;
};

/// The least number of elements that a case can have, before its mesh is made: there are none above the bed.
Real min_elements(problem::Case c)
{
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) bed->headroom = bed->near_height = 0;
  return min_size<2>(c).cells;
}

fem::FemProblem build_for(const RunRequest& request, const ScratchFolder& scratch)
{
  const problem::Case c = to_build(request);
  const Real elements = min_elements(c);
  refuse_without_memory(elements * fem::Assembly::bytes_of_element(), memory_in_use(), fmt::format("{:.4g} elements", elements),
                        larger_elements);
  return fem::build_fem(c, request.case_file.parent_path().string(), scratch.path().string());
}

}  // namespace

bool run_fem(const RunRequest& request)
{
  const ScratchFolder scratch;
  fem::FemProblem problem = build_for(request, scratch);
  return with_run_folder(request, scratch, words_of(problem.model), [&](const run_folder::RunFolder& folder, run_folder::RunLog& log) {
    return FemRun(request, std::move(problem), folder, log).to_the_end();
  });
}

void try_to_build_fem(const RunRequest& request)
{
  const ScratchFolder scratch;
  build_for(request, scratch);
}

void check_fem(const RunRequest& request)
{
  const ScratchFolder scratch;
  fem::FemProblem problem = build_for(request, scratch);
  fmt::print("{}\n", request.case_file.string());
  fmt::print("  elements     {}\n  nodes        {}\n  contact      {} points\n", problem.model.mesh.cell_count(),
             problem.model.mesh.node_count(), problem.model.contact.size());

  const Clock::time_point start = Clock::now();
  fem::Newton newton(problem.model);
  fmt::print("  memory       about {:.0f} MiB at most\n", (memory_in_use() + newton.memory_to_come()) / (1 << 20));
  std::vector<Real> change(problem.model.unknowns(), 0.);
  fem::FemLoads loads;
  loads.gravity = gravity_now(problem.model.model, problem.state.state.time);
  newton.assembly().store_initial_imbalance(problem.state, loads);
  const fem::IncrementEnd end = newton.find_equilibrium(problem.state, loads, 1, change);
  fmt::print("  time         about {:.2g} s an iteration with {} threads; a push or a drag takes some hundred iterations\n",
             seconds_since(start) / (end.iterations + 1), request.threads);
}

}  // namespace berm::simulation
