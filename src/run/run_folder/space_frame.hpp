// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "fem/space_problem.hpp"
#include "run_folder/frame.hpp"

namespace berm::run_folder {

/// Makes frames of finite elements in space: their nodes, displaced, with the mean over the elements, by their volume, of what the points of integration carry.
class SpaceFrameMaker {
public:
  explicit SpaceFrameMaker(const fem::SpaceModel& model);

  /// The strain is that of the gradient of the displacement, the increment that of the displacement since the frame before.
  Frame<3> make(const fem::SpaceState& state);
  /// From now on displacements, and their strains, count from these, by unknown.
  void zero_displacements(const std::vector<Real>& displacement) { zero_ = displacement; }
  void archive(Archive& k);

private:
  const fem::SpaceModel& model_;
  std::vector<Real> last_displacement_, zero_;  ///< by unknown: at the frame before; what displacements count from
};

}  // namespace berm::run_folder
