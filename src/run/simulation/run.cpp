// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/run.hpp"

#include "core/ranks.hpp"
#include "core/vector_unit.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "problem/lengthen.hpp"
#include "problem/stages.hpp"
#include "record/run_record.hpp"
#include "settings/time_scale.hpp"
#include "simulation/fem_method.hpp"
#include "simulation/longer_mesh.hpp"
#include "simulation/memory.hpp"
#include "simulation/mpm_method.hpp"
#include "simulation/pipeline_method.hpp"
#include "simulation/results.hpp"
#include "simulation/run_of_ranks.hpp"
#include "simulation/space_fem_method.hpp"
#include "user_law/load.hpp"

#include <malloc.h>

namespace berm::simulation {

template <class Method>
Run<Method>::Run(const RunRequest& request, Context& context, Method& method, const run_folder::RunFolder& folder, run_folder::RunLog& log,
                 const std::vector<std::string>& warnings)
    : request_(request),
      context_(context),
      method_(method),
      log_(log),
      warnings_(warnings),
      folder_(folder),
      clock_(context.timings()),
      checkpoints_(folder.path(), request.settings.output.checkpoint_wall_time),
      frames_(folder.subfolder("frames"), method.model().mesh, Ranks::of_run().is_first()),
      progress_(log),
      held_forces_(method.model().stages.size(), nan),
      unit_(vector_unit()),
      compress_(context.threads() > 1 && context.threads() >= processor_count() ? Compress::now : Compress::later)
{
}

template <class Method>
void Run<Method>::begin()
{
  const bool from_checkpoint = request_.resume && read_checkpoint();
  history_.emplace(history_path(), history_bytes_);
  if (request_.resume) frames_.remove_others();
  if (const mesh::GroundLine& line = model().ground.line; !line.level() && !from_checkpoint) record::write_ground(folder_.path(), line);
  progress_.count_from(clock_.earlier());
  method_.begin(!from_checkpoint);
  for (const settings::StageSettings& stage : model().stages)
    if (!stage.load_times.empty()) io::info("load history of stage \"{}\": {}", stage.name, time_scale_words(stage));
  if (!from_checkpoint) record(), frame();
}

/// Goes on where the last checkpoint was written; false where there is none.
template <class Method>
bool Run<Method>::read_checkpoint()
{
  const std::string own_unit = unit_;
  const bool found = Ranks::of_run().is_first() && checkpoints_.read([&](Archive& k) { archive(k); });
  if (!broadcast(found, [&](Archive& k) { archive_progress(k); })) {
    io::info("there is no checkpoint in {}: begins at the start", folder_.path().string());
    return false;
  }
  if (unit_ != own_unit)
    io::warn("the run was begun on the vector unit {}, and is resumed on {}: results are the same except for round-off", unit_, own_unit);
  return true;
}

template <class Method>
bool Run<Method>::advance()
{
  step();
  writer_.check();
  checkpoints_.tell();
  if (!decides_now()) return true;
  const bool asked_to_stop = on_any_rank(context_.asked_to_stop());
  if (asked_to_stop) checkpoints_.ask();
  if (finished_) return false;
  if (!method_.at_checkpoint_boundary() || !on_any_rank(checkpoints_.due())) return true;
  write_checkpoint();
  return !asked_to_stop;
}

template <class Method>
void Run<Method>::keep()
{
  method_.come_to_checkpoint_boundary();
  write_checkpoint();
  writer_.finish();
  if (!checkpoints_.tell())
    throw RunError(fmt::format("the state of step {} could not be written to {}", state().step, folder_.path().string()));
}

template <class Method>
void Run<Method>::keep_in(const std::filesystem::path& run_folder)
{
  history_bytes_ = history_->bytes();
  history_->sync();
  if (const mesh::GroundLine& line = model().ground.line; !line.level()) record::write_ground(run_folder, line);
  run_folder::CheckpointFolder(checkpoints_in(run_folder)).begin(state().step, [&](Archive& k) { archive(k); })();
}

template <class Method>
void Run<Method>::finish_files()
{
  const RunClock::In part(clock_.parts().frames);
  const Timer timer("wait for frames");
  writer_.finish();
  clock_.parts().beside += writer_.take_busy();
  checkpoints_.tell();
}

template <class Method>
void Run<Method>::end()
{
  finish_files();
  if constexpr (!FiniteElements<Method>) Ranks::of_run().together([&] { user_law::throw_failures(request_.settings); });
  if (finished_) return;
  if (state().time > last_row_) record();
  io::warn("stopped at t = {:.6g} s in stage \"{}\"; what was computed until then is in {}. To resume: berm run --resume {}", state().time,
           stage().name, folder_.path().string(), folder_.path().string());
}

/// Whether to stop or to write a checkpoint is looked at after every step; where ranks must agree, seldom.
template <class Method>
bool Run<Method>::decides_now() const
{
  constexpr BigIndex steps = 16;
  return Ranks::of_run().count() == 1 || finished_ || state().step % steps == steps / 2;
}

/// A user's own law that fails is the reason of what follows from it. Finite elements may get over it in a shorter increment.
template <class Method>
void Run<Method>::step_of_method()
{
  const RunClock::In part(clock_.parts().steps);
  try {
    method_.step();
  } catch (const RunError& error) {
    user_law::throw_failures(request_.settings);
    const std::string command = command_to_lengthen();
    if (command.empty()) throw;
    throw RunError(fmt::format("{}. To go on from the last checkpoint on a longer mesh: {}", error.what(), command));
  }
  if constexpr (FiniteElements<Method>)
    user_law::forget_failures(request_.settings);
  else if (decides_now())
    Ranks::of_run().together([&] { user_law::throw_failures(request_.settings); });
}

/// One step, and the output that is due after it.
template <class Method>
void Run<Method>::step()
{
  step_of_method();
  const bool ended = method_.stage_ended();
  if (ended || state().time >= next_row_) record();
  if (ended || frame_is_due()) frame();
  if (ended || progress_.due()) report_progress();
  if (ended) {
    next_stage();
    checkpoints_.ask();
  }
}

/// A history that the disk does not take ends the run, a checkpoint does not.
template <class Method>
void Run<Method>::write_checkpoint()
{
  const RunClock::In part(clock_.parts().checkpoints);
  [[maybe_unused]] const auto whole = method_.whole_state();
  if (!Ranks::of_run().is_first()) return checkpoints_.skip_checkpoint();
  history_bytes_ = history_->bytes();
  checkpoints_.write(
      state().step, [&](Archive& k) { archive(k); }, writer_, [this] { history_->sync(); },
      [this] {
        for (const std::filesystem::path& names : {folder_.path(), frames_.folder()}) io::sync_file(names);
      });
}

/// All that a checkpoint holds. What must fit comes first.
template <class Method>
void Run<Method>::archive(Archive& k)
{
  const bool of_shorter = request_.shorter != nullptr && k.reads();
  const std::string resolved = input::resolved_toml(of_shorter ? request_.shorter->settings : request_.settings);
  archive_same(k, "case", std::string(input::without_report(resolved)), "it is of another case than resolved.toml");
  if (method_.keeps_mesh()) archive_same_mesh(k, k.reads() ? method_.mesh_of_checkpoint() : model().mesh);
  k("vector_unit", unit_);
  k.table("history", [&] { archive_history(k, history_path(), history_bytes_); });
  k.table("frames", [&] { frames_.archive(k); });
  k.table("clock", [&] { clock_.archive(k); });
  archive_progress(k);
}

/// What all ranks know.
template <class Method>
void Run<Method>::archive_progress(Archive& k)
{
  k("last_row", last_row_);
  k("next_row", next_row_);
  k("frame_time", frame_time_);
  k("frame_displacement", frame_displacement_);
  k.fixed("held_forces", held_forces_);
  method_.archive(k);
}

/// Where what is driven outgrows its fine cells, and the mesh can be made longer; else "".
template <class Method>
std::string Run<Method>::command_to_lengthen() const
{
  if constexpr (FiniteElements<Method>)
    return "";
  else
    return model().main_rigid == none || !problem::not_to_lengthen(model()).empty()
               ? ""
               : simulation::command_to_lengthen(request_, method_.sides());
}

/// Where the path is not that of the case: this the case's checks have looked at before the run.
template <class Method>
void Run<Method>::advise_longer_mesh()
{
  if (advised_ || !(stage().kind == settings::StageKind::pipeline || state().stage.drive[model().axes.along].by_force)) return;
  const std::string command = command_to_lengthen();
  advised_ = !command.empty();
  if (advised_)
    io::warn("\"{}\" comes to the end of the fine cells at t = {:.4g} s: to go on in fine cells stop the run (Ctrl-C), and type {}",
             model().rigid_bodies[model().main_rigid].name, state().time, command);
}

template <class Method>
void Run<Method>::record()
{
  const RunClock::In part(clock_.parts().rows);
  method_.add_row(*history_);
  advise_longer_mesh();
  ++rows_;
  last_row_ = state().time;
  if (const Real interval = method_.history_interval(); interval > 0)
    next_row_ = (std::floor(state().time / interval * (1 + 1e-12)) + 1) * interval;
}

template <class Method>
bool Run<Method>::frame_is_due() const
{
  const settings::OutputSettings& output = request_.settings.output;
  const Real travel = driven() == none ? 0 : (state().rigid_bodies[driven()].displacement - frame_displacement_).norm();
  return method_.soil_changed() || (output.frame_time && state().time >= frame_time_ + *output.frame_time) ||
         (output.frame_travel && travel >= *output.frame_travel);
}

template <class Method>
void Run<Method>::frame()
{
  if (state().time == last_frame_) return;
  const RunClock::In part(clock_.parts().frames);
  last_frame_ = state().time;
  {
    const Timer timer("wait for frames");
    writer_.wait_for(in_hand_[1 - last_in_hand_].piece);
  }
  auto& [made, piece] = in_hand_[last_in_hand_ = 1 - last_in_hand_];
  {
    const Timer timer("make frames");
    made = method_.make_frame(std::move(made));
  }
  if (Ranks::of_run().is_first())
    if (const std::function<void()> files = frames_.write_later(made, compress_))
      piece = writer_.hand_over([files] {
        files();
        ::malloc_trim(0);  // gives back what writing took on the way: a tenth of what the run has
      });
  frame_time_ = state().time;
  if (driven() != none) frame_displacement_ = state().rigid_bodies[driven()].displacement;
}

template <class Method>
void Run<Method>::next_stage()
{
  finished_ = !method_.next_stage();
  if (finished_) return;
  const bodies::Drive& vertical = state().stage.drive[model().axes.up];
  const bool varies = load_column_of(stage(), model().axes, model().axes.up) != none;
  if (stage().kind == settings::StageKind::drag && vertical.by_force && !varies)
    held_forces_[static_cast<std::size_t>(state().stage.index)] = -model().axes.sign * model().parts * vertical.to;
}

/// The part of the run that is done, by the limits that the stages name; NaN where the present one names none.
template <class Method>
Real Run<Method>::part_done() const
{
  Real passed = 0;
  for (Index k = 0; k < state().stage.index; ++k) passed += expected_time(model().stages[k]);
  const Real of_stage = expected_time(stage());
  if (!(of_stage > 0)) return nan;
  return std::min(Real(1), (passed + std::min(of_stage, state().time - state().stage.begin_time)) / expected_time(model().stages));
}

template <class Method>
void Run<Method>::report_progress()
{
  run_folder::ProgressReport report;
  report.stage = stage().name;
  report.done = part_done();
  report.drag = stage().kind == settings::StageKind::drag;
  if (const Index main = model().main_rigid; main != none) {
    const problem::RigidTravel travel = travel_of(model(), state(), main);
    report.u = travel.u;
    report.w = travel.w;
    report.V = method_.recorder().vertical();
    report.H = method_.recorder().horizontal();
    report.whole = dim == 3 || model().mesh.metric == mesh::Metric::axisymmetric;
    report.diameter = width_of<dim>(model().rigid_bodies[main].shape);
  }
  report.particle_steps = method_.particle_steps();
  progress_.update(report);
}

template <class Method>
void Run<Method>::leave_results()
{
  if (!history_) return;
  run_folder::Summary::Checks checks = {{"finished", finished_}};
  for (auto& check : method_.checks()) checks.push_back(std::move(check));
  frame();
  finish_files();
  const std::vector<Real> memory = Ranks::of_run().all_of(largest_memory_in_use());
  if (!Ranks::of_run().is_first()) return;
  const run_folder::RunTiming timing{
      clock_.wall(),    clock_.processors(), clock_.parts(), context_.threads(), model().mesh.cell_count(), state().step,
      method_.counts(), clock_.loops(),      memory};
  EndedRun ended{
      folder_, LastState<dim>{model(), state().rigid_bodies, in_hand_[last_in_hand_].frame}, held_forces_, std::move(checks), {}};
  ended.run.folder = folder_.path();
  ended.run.settings = request_.settings;
  ended.run.ground = model().ground;
  ended.run.history = history_->history();
  const std::string results = write_results(request_, std::move(ended), context_.after(), warnings_, timing);
  if (!results.empty()) log_.result(results);
  io::info("everything is in {}", folder_.path().string());
}

template <class Method>
void Run<Method>::remove_checkpoints() const
{
  if (finished_ && Ranks::of_run().is_first()) checkpoints_.remove();
}

template class Run<MpmMethod<2>>;
template class Run<MpmMethod<3>>;
template class Run<FemMethod>;
template class Run<SpaceFemMethod>;
template class Run<PipelineMethod>;

}  // namespace berm::simulation
