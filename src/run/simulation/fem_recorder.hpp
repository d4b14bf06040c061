// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/load_steps.hpp"
#include "run_folder/history.hpp"
#include "simulation/recorder.hpp"

namespace berm::simulation {

/// Writes the rows of history.csv of a finite element run: what both methods have (recorder.hpp), with
/// iterations, unbalance (of the increment), overstress (part of the stress that lies beyond the strength) and strength_lag (part of what plastic
/// flow dissipates that is missing because the strength lags behind its pressure).
class FemRecorder : public Recorder<2> {
public:
  explicit FemRecorder(const fem::FemModel& model)
      : Recorder<2>(model.model),
        large_(model.settings.large_deformation),
        zero_(model.unknowns(), 0.)
  {
  }

  /// What a row has of the equilibria before it (LoadSteps::max_overlap); to be called after each call that finds some.
  void observe_steps(const fem::LoadSteps& steps) { note_overlap(steps.max_overlap()); }
  /// Throws RunError where a number is not finite that must be.
  void add_row(const fem::FemModel& model, const fem::FemState& state, const fem::IncrementEnd& end, const fem::Remeshings& remeshings,
               run_folder::HistoryFile& file);

  /// From now on displacements count from here: these of the nodes, and the rigid body's.
  void zero_displacements(const std::vector<Real>& displacement, const problem::State<2>& state);

  void archive(Archive& k);

  /// The largest unbalance and overstress of all rows in which a rigid body is driven.
  Real largest_unbalance() const { return largest_unbalance_; }
  Real largest_overstress() const { return largest_overstress_; }
  /// The sum of the magnitudes of what is missing (StrengthLag) over what is dissipated, of all rows in which a rigid body is driven.
  Real strength_lag() const { return lag_.part(); }

private:
  void observe_solution(const fem::FemState& state, const fem::IncrementEnd& end);
  void observe_shaft_of_main(const fem::FemModel& model, const fem::FemState& state);
  void observe_tractions(const fem::FemModel& model, const fem::FemState& state);
  void observe_watches(const fem::FemModel& model, const fem::FemState& state);

  Vec<2> displacement_of(const fem::FemModel& model, const fem::FemState& state, Index node) const;

  bool large_;              ///< deformations are: the state has what displacements count from
  std::vector<Real> zero_;  ///< by unknown, that displacements count from
  Real largest_unbalance_ = 0, largest_overstress_ = 0;
  fem::StrengthLag lag_;
};

}  // namespace berm::simulation
