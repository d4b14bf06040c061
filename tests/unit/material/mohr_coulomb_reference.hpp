// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mohr_coulomb_cases.hpp"

#include <Eigen/LU>

namespace berm::material {

/// What the enumeration of active planes finds for one trial stress.
struct ReferenceReturn {
  bool found = false;
  Vec<3> stress = Vec<3>::Zero();
  Real disagreement = 0;  ///< between admissible sets of planes, Pa
};

/// Koiter's return in principal space by brute force: every set of at most three of the nine planes (six of Mohr-Coulomb, three of the cut-off) is
/// solved for sigma = trial - sum g C m with its planes at zero, and kept if all g >= 0 and no plane is violated. Knows nothing of edges or order.
inline ReferenceReturn reference_return(const MohrCoulomb& law, const Vec<3>& trial)
{
  struct Plane {
    Vec<3> normal, flow;
    Real offset;
  };
  const Real friction = std::sin(law.friction_angle), dilation = std::sin(law.dilation_angle);
  std::vector<Plane> planes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j)
        planes.push_back({(1 + friction) / 2 * Vec<3>::Unit(i) - (1 - friction) / 2 * Vec<3>::Unit(j),
                          (1 + dilation) / 2 * Vec<3>::Unit(i) - (1 - dilation) / 2 * Vec<3>::Unit(j),
                          law.cohesion * std::cos(law.friction_angle)});
  if (law.tension_cutoff)
    for (int i = 0; i < 3; ++i) planes.push_back({Vec<3>::Unit(i), Vec<3>::Unit(i), *law.tension_cutoff});
  const Elasticity elastic = elasticity(law);
  const Matrix<3> hooke = Matrix<3>::Constant(elastic.lame) + 2 * elastic.shear * Matrix<3>::Identity();
  // Rounding of stresses of the trial's size; a violation or a negative amount of flow of this size is none.
  const Real rounding = 1e-10 * (trial.norm() + law.cohesion);

  ReferenceReturn result;
  const auto try_planes = [&](const std::vector<int>& set) {
    const int n = static_cast<int>(set.size());
    Eigen::MatrixXd system(n, n), flow(3, n);
    Eigen::VectorXd excess(n);
    for (int k = 0; k < n; ++k) {
      flow.col(k) = hooke * planes[set[k]].flow;
      excess[k] = planes[set[k]].normal.dot(trial) - planes[set[k]].offset;
    }
    for (int k = 0; k < n; ++k) system.row(k) = planes[set[k]].normal.transpose() * flow;
    Vec<3> stress = trial;
    if (n > 0) {
      Eigen::FullPivLU<Eigen::MatrixXd> solver(system);
      if (!solver.setThreshold(1e-9).isInvertible()) return;
      const Eigen::VectorXd amount = solver.solve(excess);
      if (amount.minCoeff() < -rounding / elastic.shear) return;
      stress -= flow * amount;
    }
    for (const Plane& plane : planes)
      if (plane.normal.dot(stress) - plane.offset > rounding) return;
    if (result.found) result.disagreement = std::max(result.disagreement, (stress - result.stress).norm());
    result.found = true;
    result.stress = stress;
  };
  const int count = static_cast<int>(planes.size());
  try_planes({});
  for (int i = 0; i < count; ++i) {
    try_planes({i});
    for (int j = 0; j < i; ++j) {
      try_planes({i, j});
      for (int k = 0; k < j; ++k) try_planes({i, j, k});
    }
  }
  return result;
}

}  // namespace berm::material
