// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/contact_step.hpp"
#include "fem/frontal_solver.hpp"

#include <variant>

namespace berm::fem {

/// How an increment ended.
struct IncrementEnd {
  bool converged = false;
  Real unbalance =
      infinity;  ///< sum of the unbalanced nodal forces over that of the contact forces, or over a thousandth of weight and tractions if that is more
  int iterations = 0;
  StrengthLag lag;  ///< of soil whose flow is not associated
};

/// Newton's iteration with the consistent tangent of the soil for one increment; the contact is solved within each step (ContactStep). Each increment is a
/// convex problem but for the friction of the interface, so a line search along the step, on the slope of the energy, keeps the iteration from cycling
/// between states of soil without tension. A decomposed matrix serves as long as it brings the unbalanced forces down fast. Where the model is unsymmetric
/// there is no energy: the search halves a step until the residual falls.
///
/// Where water flows the equations are a saddle point. The balance of the water is linear: the first whole step satisfies it, and parts of later steps keep
/// it. The slope over the displacements is then that of the convex energy in which the pressures are functions of the displacements.
class Newton {
public:
  explicit Newton(const FemModel& model);

  /// Looks for the change of displacement that brings equilibrium; `change` is the guess at first. The state stays as it is; assembly() holds what was found.
  IncrementEnd find_equilibrium(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change);

  /// Bytes that the iteration takes beside what it has had since it was made.
  Real memory_to_come() const
  {
    return std::visit([](const auto& solver) { return solver.memory(); }, solver_);
  }

  Assembly& assembly() { return assembly_; }
  const Assembly& assembly() const { return assembly_; }

private:
  bool factorize();
  bool set_step(const FemState& begin, const FemLoads& loads, const std::vector<Real>& change);
  void find_step(const FemState& begin, const std::vector<Real>& change);
  Real slope() const;
  void search_by_residual(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change);
  void search_line(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change);

  const FemModel& model_;
  Assembly assembly_;
  ContactStep contact_;
  std::variant<FrontalSolver, DirectSolver> solver_;  ///< the second where water flows or the model is unsymmetric: it finds pivots
  Real min_force_;                                    ///< N/m, that unbalanced forces are compared with at least
  std::vector<Real> step_;
};

}  // namespace berm::fem
