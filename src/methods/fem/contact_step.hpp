// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/assembly.hpp"

#include <span>

namespace berm::fem {

/// Newton's step with the soil linearized and the contact nonlinear: points open, close, stick and slip within it. With the
/// soil condensed onto the unknowns of the contact the step y solves
///
///   S y - f(change + y) = load
///
/// with the Schur complement S of the soil and the forces f of the interface, by a small Newton iteration of its own with
/// line search: on the slope of the energy, or on the residual where the soil has none.
class ContactStep {
public:
  explicit ContactStep(const FemModel& model);

  /// x and y of each contact point's node, then the three of each rigid body; none without contact.
  const std::vector<Index>& unknowns() const { return unknowns_; }

  /// The step from `change` on, by unknown of the contact, replaces the load (N/m; the step itself where the unknown is
  /// prescribed). `soil` is S, row by row, where the model is symmetric its lower triangle (N/m2). False where the iteration does not converge; the step is
  /// then Newton's with the contact linearized at `change`.
  bool find(const FemState& begin, const std::vector<Real>& change, const Assembly& assembly, std::span<const Real> soil,
            std::span<Real> load);

private:
  using Vector = Eigen::VectorXd;
  using RowMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void evaluate(const FemState& begin, const Vector& step, bool with_stiffness);
  Real step_length(const FemState& begin, const Vector& load);
  Real step_length_by_residual(const FemState& begin, const Vector& load);

  const FemModel& model_;
  std::vector<Index> unknowns_;
  std::vector<char> prescribed_;
  Vector change_, force_, step_, first_step_, direction_, unbalanced_;
  RowMatrix soil_, matrix_, stiffness_;
};

}  // namespace berm::fem
