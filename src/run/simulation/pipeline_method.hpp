// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/mpm_method.hpp"
#include "slices/coupled_line.hpp"
#include "slices/soil_columns.hpp"
#include "slices/springs_beside.hpp"

namespace berm::simulation {

/// A pipeline on slices of soil as a Run needs it: the first slice is a run of the material point method, which lays the pipe; in stages of kind pipeline all slices are coupled to the line.
class PipelineMethod {
public:
  static constexpr int dim = 2;

  PipelineMethod(const RunRequest& request, const io::ScratchFolder& scratch);

  // Of the first slice.
  const problem::Model<2>& model() const { return first_.model(); }
  const problem::State<2>& state() const { return first_.state(); }
  const MpmRecorder<2>& recorder() const { return first_.recorder(); }
  sanity::Scene scene(const RunRequest& request, int threads) { return first_.scene(request, threads); }
  Real expected_wall_time() { return first_.expected_wall_time(); }
  void begin(bool at_start);
  bool soil_changed() const { return first_.soil_changed(); }
  bool keeps_mesh() const { return true; }
  Real history_interval() const { return first_.history_interval(); }
  bool stage_ended() const { return first_.stage_ended(); }
  bool at_checkpoint_boundary() const { return first_.at_checkpoint_boundary(); }
  void limit_time_step(Real dt) { first_.limit_time_step(dt); }
  Real contact_mass() const { return first_.contact_mass(); }
  run_folder::MpmCounts counts() const { return first_.counts(); }

  std::string size_words() const;
  Estimate estimate(const Context& context);

  void step();
  /// With columns of the line and of the other slices.
  void add_row(run_folder::HistoryFile& file);
  /// That of the first slice; and line.csv and berms.csv, with the shapes of the line and of the beds of its slices so far, and springs.csv, with the resistance of springs beside.
  run_folder::Frame<2> make_frame(run_folder::Frame<2> old);
  bool next_stage();
  void come_to_checkpoint_boundary();
  /// The line drives the slices: throws InputError in stages of kind pipeline.
  void drive(int freedom, bool by_force, Real value);
  void archive(Archive& k);
  /// As MpmMethod::lengthen.
  void lengthen(std::unique_ptr<PipelineMethod> before);
  const mesh::Mesh<2>& mesh_of_checkpoint() const { return first_.mesh_of_checkpoint(); }
  /// Of the pipes in all slices.
  Sides sides() const;
  /// Of all slices, on the first rank.
  mpm::WholeState<2> whole_state();

  run_folder::Summary::Checks checks() const;
  Real particle_steps() const;

private:
  Real memory_of_others() const;
  void make_soils(const RunRequest& request, const io::ScratchFolder& scratch);
  void add_line(run_folder::Row& row);
  void add_slices(run_folder::Row& row);
  Real energy_error_of_slices();
  void note_shape();
  void note_berms();
  void take_berms(const PipelineMethod& before);
  const problem::State<2>& slice(std::size_t k) const;
  void write_shapes() const;
  void write_berms() const;
  bool find_springs();
  void write_springs() const;
  bool on_line() const { return model().stages[state().stage.index].kind == settings::StageKind::pipeline; }

  std::filesystem::path folder_;
  std::unique_ptr<PipelineMethod> before_;  ///< until begin(): on the shorter mesh
  MpmMethod<2> first_;
  slices::CoupledLine line_;
  std::optional<slices::SpringsBeside> springs_;
  std::vector<std::unique_ptr<MpmMethod<2>>> soils_;  ///< the slices of other soil, as the pipe is laid there
  BigIndex hung_at_ = 0;                              ///< step
  Real last_row_ = 0;                                 ///< s
  std::vector<problem::Ledger<2>> last_;              ///< by slice, at the last row
  std::vector<Real> works_;                           ///< J/m, the largest done, by slice
  Real largest_slope_ = 0;                            ///< of all rows
  Real energy_error_of_slices_ = 0;                   ///< of all rows
  Real largest_contact_mass_ = 0;                     ///< over the line's mass, of all rows
  std::vector<Real> shapes_;                          ///< numbers of line.csv, by frame and node
  std::vector<Index> stages_;                         ///< by frame
  slices::SoilColumns columns_;                       ///< of the soil of a slice
  std::vector<std::vector<Real>> level_;              ///< m, by slice: their heights before the first step
  std::vector<Real> berms_;                           ///< m: how far they have risen, by frame, slice and column
  Index first_frame_of_berms_ = 0;                    ///< once the slices are coupled
};

}  // namespace berm::simulation
