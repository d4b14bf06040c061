// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "fem/fem_problem.hpp"
#include "run_folder/frame.hpp"

namespace berm::run_folder {

/// Makes frames of a finite element run: its nodes, displaced, with what their elements' points of integration carry, drawn out linearly to the
/// nodes of each element and averaged over the elements by their area.
class FemFrameMaker {
public:
  explicit FemFrameMaker(const fem::FemModel& model);

  /// The strain is that of the gradient of the displacement, the increment that of the displacement since the frame before.
  Frame<2> make(const fem::FemState& state);

  /// From now on displacements, and their strains, count from these, by unknown.
  void zero_displacements(const std::vector<Real>& displacement) { zero_ = displacement; }

  /// What the increments of the next frame count from; what displacements count from where a stage says so.
  void archive(Archive& k);

private:
  const fem::FemModel& model_;
  std::vector<Real> last_displacement_;  ///< by unknown, at the frame before
  std::vector<Real> zero_;               ///< by unknown, what displacements count from
};

}  // namespace berm::run_folder
