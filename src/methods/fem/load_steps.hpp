// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "fem/newton.hpp"
#include "fem/remesher.hpp"
#include "os/error.hpp"

namespace berm::fem {

/// The soil carries its loads in no equilibrium that could be found.
struct NoEquilibrium : RunError {
  using RunError::RunError;
};

/// The remeshings of a run: how many there were, how the reactions of the bodies changed by mapping and the equilibrium after it, and what these took from the soil.
struct Remeshings {
  BigIndex count = 0;
  Real largest_force = 0, sum_of_forces = 0;    ///< N/m: contact forces before a remeshing
  Real largest_change = 0, sum_of_changes = 0;  ///< N/m, of these
  BigIndex folds = 0;                           ///< places at which soil folded onto soil
  Real lost_energy = 0;                         ///< J/m, elastic energy of the soil that became neither work nor plastic flow
  Real lost_area = 0;                           ///< m2, around an axis m3 per radian

  Real mean_change() const { return sum_of_forces > 0 ? sum_of_changes / sum_of_forces : 0; }                ///< over the force
  Real largest_change_over_force() const { return largest_force > 0 ? largest_change / largest_force : 0; }  ///< over the largest force
};

/// Goes through the stages of a case in increments that adapt: one that does not converge is tried again at half its size, one that converges quickly
/// lets the next grow. Each starts from the last one's change, scaled. The viscosity eta of an increment (Assembly::evaluate) is relaxation over
/// travel, so that the overstress belongs to the speed of the strain and not to the size of the increments; the relaxation falls while increments
/// converge quickly, and rises where they do not. Where the strength follows the pressure (associated()), the equilibrium of an increment is found again
/// with a strength 0.7 of the way to that at its end, or more, until that lags by a hundredth at most (StrengthLag), and an increment in which the contact
/// force changes by more than a fiftieth makes the next shorter. Where water flows, the error of the pressures in an increment limits the next.
/// Where forces alone move a body in large deformations, its mass is accelerated, and the error of its movement limits the increments.
class LoadSteps {
public:
  /// `remesher`: where deformations are large.
  LoadSteps(FemModel& model, FemState& state, std::optional<Remesher> remesher = {});

  /// Bytes that the increments take beside what they have had since this was made.
  Real memory_to_come() const { return newton_->memory_to_come(); }

  /// Finds the equilibrium of the first state, the rigid body at rest: under its weight consolidated soil has no excess pore pressure; tractions of the
  /// start come at once, and no water has flowed since. Throws NoEquilibrium where it finds none.
  void find_first_equilibrium();

  /// One increment of the present stage, to its end at most. Throws NoEquilibrium where even the smallest increment finds no equilibrium.
  IncrementEnd advance();

  /// Goes to the next stage; false after the last one. Where supports are released their reactions are taken away first, at one moment, the rigid body at rest.
  /// Throws NoEquilibrium where the soil finds none without them.
  bool next_stage();

  /// How deep the rigid body's contact points were in the soil at most, m, in the equilibria that the last of these three found.
  Real max_overlap() const { return max_overlap_; }

  /// The iteration that finds the equilibria.
  Newton& newton() { return *newton_; }

  /// What remeshings have done to the run.
  const Remeshings& remeshings() const { return remeshings_; }

  /// In large deformations the mesh, before what is of it.
  void archive_mesh(Archive& k);
  /// What the next increment takes from those before it, beside the state.
  void archive(Archive& k);

private:
  const settings::StageSettings& stage() const { return model_.model.stages[state_.state.stage.index]; }
  Index driven() const { return model_.model.driven[state_.state.stage.index]; }
  void begin();
  bool release_imbalance(FemLoads loads, Real viscosity);
  void remesh();
  Real viscosity_of(Real dt) const;
  Real longest_dt() const;
  bool goes_too_far(const std::vector<Real>& change) const;
  bool keeps_energy(const std::vector<Real>& change, const FemLoads& loads);
  Real speed_of_body() const;
  Real mass_of_body(int freedom) const;
  Real inertia_error(const std::vector<Real>& change, const FemLoads& loads) const;
  FemLoads dead_loads(Real time) const;
  FemLoads loads_after(Real dt) const;
  Vec<2> reaction_now() const
  {
    return driven() == none ? Vec<2>(Vec<2>::Zero()) : newton_->assembly().reaction(model_.contact_of(driven()));
  }
  IncrementEnd find_equilibrium(const FemLoads& loads, Real dt, std::vector<Real>& change);
  Real next_dt_of_flow(const std::vector<Real>& change, Real dt);
  void accept(const std::vector<Real>& change, const FemLoads& loads, const IncrementEnd& end, Real force_change);
  void note_velocity(const std::vector<Real>& change, const FemLoads& loads);
  void accept_equilibrium(const std::vector<Real>& change, const FemLoads& loads);
  [[noreturn]] void refuse_overstress() const;

  FemModel& model_;
  FemState& state_;
  std::optional<Remesher> remesher_;
  Remeshings remeshings_;
  std::unique_ptr<Newton> newton_;
  Real min_relaxation_, relaxation_;       ///< travel over which overstress fades, over the width: at least, and of the next increment
  Real first_dt_ = 0, dt_ = 0;             ///< s, of the first and of the next increment of the stage
  Real shortest_dt_ = 0;                   ///< s, of the increments that the error of the pressures limits
  Real last_dt_ = 0;                       ///< s, of the last increment in this stage; 0 = none
  int last_iterations_ = 0;                ///< of Newton, where the equilibrium of an increment was found the last time
  bool accepted_above_tolerance_ = false;  ///< the last increment was taken though it stayed above the tolerance
  Real largest_pressure_ = 0;              ///< Pa2, of the excess pore pressures of the stage: largest sum of their squares
  std::vector<Real> last_change_;          ///< by unknown, in it
  Real max_overlap_ = 0;                   ///< m
  Real imbalance_work_ = 0;                ///< J/m, of fictitious forces since the last mapping
};

}  // namespace berm::fem
