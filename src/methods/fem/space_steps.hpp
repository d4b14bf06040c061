// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "fem/load_steps.hpp"
#include "fem/space_newton.hpp"

namespace berm::fem {

/// Goes through the stages of a case in space in increments that adapt, as LoadSteps does in the plane where nothing flows, no strength follows a pressure and nothing is remeshed.
class SpaceSteps {
public:
  SpaceSteps(const SpaceModel& model, SpaceState& state);

  /// Finds the equilibrium of the first state, the rigid bodies at rest. Throws NoEquilibrium where it finds none.
  void find_first_equilibrium();
  /// One increment of the present stage, to its end at most. Throws NoEquilibrium where even the smallest increment finds no equilibrium.
  IncrementEnd advance();
  /// Goes to the next stage; false after the last one. Throws NoEquilibrium where the soil finds none without supports that are released.
  bool next_stage();

  SpaceNewton& newton() { return newton_; }
  /// What the next increment takes from those before it, beside the state.
  void archive(Archive& k);

private:
  const settings::StageSettings& stage() const { return model_.model.stages[state_.state.stage.index]; }
  Index driven() const { return model_.model.driven[state_.state.stage.index]; }
  void begin();
  bool release_imbalance();
  ElementLoads<3> dead_loads(Real time) const;
  ElementLoads<3> loads_after(Real dt) const;
  void accept(const std::vector<Real>& change, const ElementLoads<3>& loads, const IncrementEnd& end);

  const SpaceModel& model_;
  SpaceState& state_;
  SpaceNewton newton_;
  Real min_relaxation_, relaxation_;  ///< travel over which overstress fades, over the width: at least, and of the next increment
  Real first_dt_ = 0, longest_dt_ = 0, dt_ = 0;  ///< s, of the first, the longest and the next increment of the stage
  Real last_dt_ = 0;                             ///< s, of the last increment in this stage; 0 = none
  bool accepted_above_tolerance_ = false;        ///< the last increment was taken though it stayed above the tolerance
  std::vector<Real> last_change_;                ///< by unknown, in it
};

}  // namespace berm::fem
