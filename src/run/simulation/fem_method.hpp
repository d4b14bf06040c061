// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/load_steps.hpp"
#include "io/scratch_folder.hpp"
#include "run_folder/fem_frame.hpp"
#include "run_folder/summary.hpp"
#include "sanity/scene.hpp"
#include "simulation/fem_recorder.hpp"
#include "simulation/simulate.hpp"
#include "simulation/trial.hpp"

namespace berm::simulation {

/// The finite element method as a Run needs it; a step is an increment.
class FemMethod {
public:
  static constexpr int dim = 2;

  /// Builds the problem; mesh files go to the scratch folder. Throws InputError and RunError.
  FemMethod(const RunRequest& request, const io::ScratchFolder& scratch);
  FemMethod(const FemMethod&) = delete;
  FemMethod& operator=(const FemMethod&) = delete;

  /// "3052 elements, 6287 nodes".
  std::string size_words() const;
  /// What the questions of good sense look at.
  sanity::Scene scene(const RunRequest& request, int threads) const;
  /// Size, memory, and time by that of an iteration.
  Estimate estimate(const Context& context);
  /// Wall time of all stages, s, by that of an iteration.
  Real expected_wall_time();

  const problem::Model<2>& model() const { return problem_.model.model; }
  const problem::State<2>& state() const { return problem_.state.state; }
  const FemRecorder& recorder() const { return recorder_; }

  /// Before the first increment; the start finds its equilibrium. Throws RunError where it finds none, but in a trial of the factor of safety.
  void begin(bool at_start);
  void step();
  bool soil_changed() const { return false; }
  /// False: a checkpoint holds the mesh that the state is of.
  bool keeps_mesh() const { return !problem_.model.settings.large_deformation; }
  const mesh::Mesh<2>& mesh_of_checkpoint() const { return model().mesh; }
  /// A row for each increment.
  Real history_interval() const { return 0; }
  void add_row(run_folder::HistoryFile& file);
  run_folder::Frame<2> make_frame(run_folder::Frame<2>);
  /// False after the last one.
  bool stage_ended() const { return problem::stage_ended(model(), state()) || (trial_ && trial_->failed()); }
  bool next_stage();
  bool at_checkpoint_boundary() const { return true; }
  void come_to_checkpoint_boundary() const {}
  void archive(Archive& k);
  /// One process has all.
  struct Whole {};
  Whole whole_state() const { return {}; }

  /// What shows whether the run can be trusted; what does not is a warning in the log, too.
  run_folder::Summary::Checks checks() const;
  run_folder::FemCounts counts() const { return {problem_.model.mesh.node_count(), iterations_}; }
  /// There are no particles.
  Real particle_steps() const { return 0; }

private:
  Real measure_iteration();
  Real time_of_stages(Real iteration) const;
  template <class Act>
  void try_to(const Act& act);
  Real movement() const;
  void end_stage_of_trial();
  bool is_last_stage() const;

  Real memory_for_mesh_;  ///< bytes in use while gmsh makes the mesh, with its own
  fem::FemProblem problem_;
  fem::LoadSteps steps_;
  FemRecorder recorder_;
  run_folder::FemFrameMaker frame_maker_;
  fem::IncrementEnd last_{true, 0, 0, {}};
  BigIndex iterations_ = 0, accepted_above_tolerance_ = 0;
  Real factor_ = 1;               ///< of safety
  std::optional<Trial> trial_;    ///< of it
  std::vector<Real> moved_from_;  ///< m, displacements that its movement counts from
};

}  // namespace berm::simulation
