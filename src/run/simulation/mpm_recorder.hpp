// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/body_sums.hpp"
#include "mpm/grid.hpp"
#include "run_folder/history.hpp"
#include "simulation/recorder.hpp"
#include "simulation/watch_point.hpp"

namespace berm::simulation {

/// Writes the rows of history.csv of a run of the material point method. Forces are impulses over the time since the row before, so that nothing between
/// two rows is lost.
template <int dim>
class MpmRecorder : public Recorder<dim> {
public:
  /// Remembers the start, from which displacements and energies count.
  MpmRecorder(const settings::Case& c, const problem::Model<dim>& model, const problem::State<dim>& start);

  /// What a row has of the steps before it; to be called after each.
  void observe_step(const problem::Model<dim>& model, const mpm::Workspace<dim>& workspace);
  /// `more` adds the last columns. Throws RunError where a number is not finite that must be.
  void add_row(const problem::Model<dim>& model, const problem::State<dim>& state, const mpm::Workspace<dim>& workspace,
               run_folder::HistoryFile& file, const std::function<void(run_folder::Row&)>& more = {});

  /// From now on displacements count from here.
  void zero_displacements(const problem::Model<dim>& model, const problem::State<dim>& state);

  /// What the next row takes from those before it. What is remembered of the start is not kept, unless a stage has displacements count anew.
  void archive(Archive& k);

  /// Of the last row: sum of unbalanced nodal forces over weight and tractions.
  Real out_of_balance() const { return out_of_balance_; }
  /// The mean over the rows in which the main rigid body was driven of how the soil near it shakes (mpm/condition.hpp); NaN without such rows.
  Real shaking() const { return shaken_rows_ > 0 ? shaking_ / shaken_rows_ : nan; }

private:
  using Recorder<dim>::row_;

  void observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid);
  void observe_rotation_of(const problem::State<dim>& state, Index rigid);
  void observe_energies(const problem::Model<dim>& model, const problem::State<dim>& state, Real kinetic);
  void observe_contact_of_main(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_body(const mpm::BodySums<dim>& sums, const Vec<dim>& first_center);
  void observe_contacts(const problem::Model<dim>& model, const problem::State<dim>& state, const mpm::Workspace<dim>& workspace);
  void observe_tractions(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_supports(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_motions(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_heads(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_depth_slices(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_effective_normals(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_earthworks(const problem::Model<dim>& model, const problem::State<dim>& state);
  void observe_watches(const problem::Model<dim>& model, const problem::State<dim>& state);

  Real last_time_ = 0;
  problem::Ledger<dim> last_, since_;    ///< at the last row, and since then while a row is made
  std::vector<Vec<dim>> first_centers_;  ///< of mass, by body
  std::vector<WatchPoint<dim>> watch_points_;
  std::vector<std::vector<Vec<dim>>> head_areas_;  ///< m (per metre run) or m2, by head and its nodes, along the normal into the soil
  std::vector<Vec<dim>> watch_zeros_;              ///< displacements of the watched points that count as none
  std::vector<problem::LoadPointState<dim>> first_loaded_;
  Real first_elastic_ = 0;  ///< J/m or J, of the stress at the start, in elastic soil; 0 where a stage drives a body
  Real first_kinetic_ = 0;
  Real out_of_balance_ = nan;
  Real shaking_ = 0, shaken_rows_ = 0;  ///< sum over rows, and their number
};

}  // namespace berm::simulation
