// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/space_steps.hpp"
#include "io/scratch_folder.hpp"
#include "run_folder/space_frame.hpp"
#include "run_folder/summary.hpp"
#include "sanity/scene.hpp"
#include "simulation/recorder.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// Writes the rows of history.csv of finite elements in space: those of FemRecorder that do not need contact, water or remeshing.
class SpaceFemRecorder : public Recorder<3> {
public:
  using Recorder<3>::Recorder;

  void add_row(const fem::SpaceModel& model, const fem::SpaceState& state, const fem::IncrementEnd& end, run_folder::HistoryFile& file);
  /// From now on displacements of rigid bodies count from here.
  void zero_displacements(const problem::State<3>& state) { zero_rigid_bodies(state); }
  void archive(Archive& k);

  /// Of all rows in which a rigid body is driven.
  Real largest_unbalance() const { return largest_unbalance_; }
  Real largest_overstress() const { return largest_overstress_; }

private:
  Real largest_unbalance_ = 0, largest_overstress_ = 0;
};

/// Finite elements in space as a Run needs them; a step is an increment.
class SpaceFemMethod {
public:
  static constexpr int dim = 3;

  /// Builds the problem; mesh files go to the scratch folder. Throws InputError and RunError.
  SpaceFemMethod(const RunRequest& request, const io::ScratchFolder& scratch);
  SpaceFemMethod(const SpaceFemMethod&) = delete;
  SpaceFemMethod& operator=(const SpaceFemMethod&) = delete;

  /// "3052 elements, 6287 nodes".
  std::string size_words() const;
  /// What the questions of good sense look at.
  sanity::Scene scene(const RunRequest& request, int threads) const;
  /// Size, memory, and time by that of an iteration.
  Estimate estimate(const Context& context);
  /// Wall time of all stages, s, by that of an iteration.
  Real expected_wall_time();

  const problem::Model<3>& model() const { return problem_.model.model; }
  const problem::State<3>& state() const { return problem_.state.state; }
  const SpaceFemRecorder& recorder() const { return recorder_; }

  /// Before the first increment; the start finds its equilibrium. Throws RunError where it finds none.
  void begin(bool at_start);
  void step();
  bool soil_changed() const { return false; }
  bool keeps_mesh() const { return true; }
  const mesh::Mesh<3>& mesh_of_checkpoint() const { return model().mesh; }
  /// A row for each increment.
  Real history_interval() const { return 0; }
  void add_row(run_folder::HistoryFile& file) { recorder_.add_row(problem_.model, problem_.state, last_, file); }
  run_folder::Frame<3> make_frame(run_folder::Frame<3>) { return frame_maker_.make(problem_.state); }
  bool stage_ended() const { return problem::stage_ended(model(), state()); }
  bool next_stage();
  bool at_checkpoint_boundary() const { return true; }
  void come_to_checkpoint_boundary() const {}
  void archive(Archive& k);
  /// One process has all.
  struct Whole {};
  Whole whole_state() const { return {}; }

  /// What shows whether the run can be trusted.
  run_folder::Summary::Checks checks() const;
  run_folder::FemCounts counts() const { return {problem_.model.mesh.node_count(), iterations_}; }
  /// There are no particles.
  Real particle_steps() const { return 0; }

private:
  Real measure_iteration();

  fem::SpaceProblem problem_;
  fem::SpaceSteps steps_;
  SpaceFemRecorder recorder_;
  run_folder::SpaceFrameMaker frame_maker_;
  fem::IncrementEnd last_{true, 0, 0, {}};
  BigIndex iterations_ = 0, accepted_above_tolerance_ = 0;
};

}  // namespace berm::simulation
