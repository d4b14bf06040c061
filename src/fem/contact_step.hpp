// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/assembly.hpp"

#include <span>

namespace berm::fem {

/// Newton's step where the soil keeps its stiffness but the contact does not: points open, close, stick and slide within it. With the soil condensed onto
/// the contact's unknowns the step y of these solves
///
///   S y - f(change + y) = load
///
/// with the Schur complement S of the soil and the forces f of the interface. That is small, and has an iteration and line searches of its own.
class ContactStep {
public:
  explicit ContactStep(const FemModel& model);

  /// x and y of each contact point's node, then the three of the rigid body; none where nothing touches.
  const std::vector<Index>& unknowns() const { return unknowns_; }

  /// The step from `change` on, by contact's unknown, is written over the load (N/m; the step itself where the unknown is given). `soil` is S, row
  /// by row, of which the lower triangle is read (N/m2). False where the contact does not settle; the step is then
  /// Newton's, with the contact as it stands.
  bool find(const FemState& begin, const std::vector<Real>& change, const Assembly& assembly, std::span<const Real> soil,
            std::span<Real> load);

private:
  using Vector = Eigen::VectorXd;
  using RowMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void evaluate(const FemState& begin, const Vector& step, bool with_stiffness);
  Real part_of_direction(const FemState& begin, const Vector& load);

  const FemModel& model_;
  std::vector<Index> unknowns_;
  std::vector<char> given_;
  Vector change_, force_, step_, first_step_, direction_, unbalanced_;
  RowMatrix soil_, matrix_, stiffness_;
};

}  // namespace berm::fem
