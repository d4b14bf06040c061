// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/scratch_folder.hpp"
#include "mpm/condition.hpp"
#include "mpm/contact_mass.hpp"
#include "mpm/divide.hpp"
#include "run_folder/frame_maker.hpp"
#include "run_folder/summary.hpp"
#include "sanity/scene.hpp"
#include "simulation/cell_watch.hpp"
#include "simulation/longer_mesh.hpp"
#include "simulation/mpm_recorder.hpp"
#include "simulation/simulate.hpp"
#include "simulation/trial.hpp"

#include <chrono>

namespace berm::simulation {

/// The material point method as a Run needs it.
template <int d>
class MpmMethod {
public:
  static constexpr int dim = d;

  /// Builds the problem; mesh files go to the scratch folder. A run that there is no memory for is refused as early as its size is known. Throws InputError
  /// and RunError.
  MpmMethod(const RunRequest& request, const io::ScratchFolder& scratch);
  ~MpmMethod();
  MpmMethod(const MpmMethod&) = delete;
  MpmMethod& operator=(const MpmMethod&) = delete;

  /// "3052 cells, 18000 particles".
  std::string size_words() const;
  /// What the questions of good sense look at, before the first step.
  sanity::Scene scene(const RunRequest& request, int threads);
  /// Prints size, memory, time step and the time that a run would take, which is measured on the first steps.
  Estimate estimate(const Context& context);
  /// Wall time of the stages whose duration is known in advance, s, measured likewise; NaN where none is.
  Real expected_wall_time();

  const problem::Model<d>& model() const { return problem_.model; }
  const problem::State<d>& state() const { return problem_.state; }
  const MpmRecorder<d>& recorder() const { return recorder_; }

  /// Before the first step, of the start or of a checkpoint.
  void begin(bool at_start);
  void step();
  /// Steps through all stages before the first of this kind, without rows and words.
  void step_to(settings::StageKind kind);
  /// Whether soil was placed or taken out before the last step.
  bool soil_changed() const { return soil_changed_; }
  bool keeps_mesh() const { return true; }
  /// s between rows of the history.
  Real history_interval() const { return history_interval_; }
  void add_row(run_folder::HistoryFile& file) { add_row(file, {}); }
  /// Of the whole problem, on the first rank. An old one gives its memory.
  run_folder::Frame<d> make_frame(run_folder::Frame<d> old);
  /// Whether a limit of the stage is reached, or the equilibrium that ends it.
  bool stage_ended() const;
  /// False after the last one.
  bool next_stage();
  /// The time step is chosen by the velocities of the nodes in the step before, which are no part of the state: not where it is due.
  bool at_checkpoint_boundary() const;
  /// Chooses it now. Throws RunError where earthworks, which come before it, may be due.
  void come_to_checkpoint_boundary();
  /// As problem::drive_otherwise.
  void drive(int freedom, bool by_force, Real value);
  /// No step is longer from now on, s.
  void limit_time_step(Real dt);
  void archive(Archive& k);
  /// The checkpoint that is read before begin() is of this run on a shorter mesh of the same case. Throws KeyError where that cannot be carried to the longer one.
  void lengthen(std::unique_ptr<MpmMethod> before);
  void lengthen(MpmMethod& before);
  /// The mesh of the checkpoint that is read before begin().
  const mesh::Mesh<d>& mesh_of_checkpoint() const { return before_ == nullptr ? model().mesh : before_->model().mesh; }
  /// The state before that checkpoint was read, where it is of a shorter mesh.
  const std::optional<problem::State<d>>& start() const { return start_; }
  /// Of the main rigid body, where there is one.
  Sides sides() const;
  /// The state of all ranks, on the first of them, while this lives.
  mpm::WholeState<d> whole_state();

  /// Of the soil at the nodes that contacts moved in the last step, kg/m or kg; 0 before the first.
  Real contact_mass() const { return workspace_ ? mpm::contact_mass(*workspace_) : 0; }

  /// What shows whether the run can be trusted; what does not is a warning in the log, too.
  run_folder::Summary::Checks checks() const;
  run_folder::MpmCounts counts() const { return counts_; }
  /// Since the start.
  Real particle_steps() const { return static_cast<Real>(counts().particles * state().step); }

  // For a line on several problems, of which this is the first.
  const settings::Case& case_of_run() const { return case_; }
  const problem::Problem<d>& problem() const { return problem_; }
  problem::State<d>& state_now() { return problem_.state; }
  mpm::Workspace<d>& workspace() { return *workspace_; }
  /// Adds columns of its own to each row.
  using MoreColumns = std::function<void(run_folder::Row&)>;
  void add_row(run_folder::HistoryFile& file, const MoreColumns& more);
  /// In stages of kind pipeline so many problems like this one are stepped, which take so much memory beside it, bytes.
  void expect_slices(std::size_t count, Real memory) { slices_ = static_cast<Real>(count), memory_of_slices_ = memory; }

private:
  /// What a step takes on a free machine, s: the least of trials of 20 ms of processor time, a quarter of a second in all; dt = the stable time step before them.
  struct Pace {
    Real dt, seconds_a_step;
  };
  Pace measure_pace();
  void enter_next_stage();
  void take_from_shorter();
  Real expected_steps_time() const;
  void refuse_other_problem() const;
  void divide_anew();
  bool change_soil();
  void zero_displacements();
  bool is_at_rest() const;
  void begin_trial();
  void end_stage_of_trial();
  bool is_last_stage() const;
  void log_equilibrium(const settings::StageSettings& stage) const;
  void log_force_limit(const settings::StageSettings& stage);
  std::vector<std::string> load_history_lines() const;
  Real stopped_over_work() const;
  void warn_of(const mpm::SoilCondition& soil) const;

  Real memory_before_;                      ///< bytes in use before the problem was built
  Real slices_ = 1, memory_of_slices_ = 0;  ///< expect_slices
  settings::Case case_;
  problem::Problem<d> problem_;
  run_folder::MpmCounts counts_;
  Real history_interval_;
  MpmRecorder<d> recorder_;
  run_folder::FrameMaker<d> frame_maker_;
  std::optional<mpm::Workspace<d>> workspace_;  ///< made of the state that the run begins with or is resumed from
  // Since when it is measured how long this rank works without waiting, 0 where it is not; and s that it had waited for others until then.
  std::chrono::steady_clock::time_point measured_since_;
  Real waited_ = 0;
  bool soil_changed_ = false;
  BigIndex next_division_ = 0, steps_between_divisions_ = 0;
  CellWatch<d> cells_;
  Real equilibrium_ = nan;
  Real beyond_force_limit_ = nan;  ///< the largest of all stages, over the limit
  // Until begin(): on the shorter mesh.
  MpmMethod* before_ = nullptr;
  std::unique_ptr<MpmMethod> own_before_;
  std::optional<problem::State<d>> start_;
  std::optional<Trial> trial_;  ///< of the factor of safety
  WindowMeans drift_;           ///< of its movement
  ParticlePlaces<d> places_;    ///< that its movement counts from
};

}  // namespace berm::simulation
