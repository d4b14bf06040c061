// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dual.hpp"
#include "material/increment.hpp"

#include <algorithm>

namespace berm::material {

/// d(s_xx, s_yy, s_zz, s_xy) / d(e_xx, e_yy, gamma_xy) of plane strain, gamma_xy = 2 e_xy, Pa. Rows 0, 1 and 3 are what the B-matrix of finite
/// elements meets.
using Tangent = Eigen::Matrix<Real, 4, 3, Eigen::DontAlign>;

/// update, and the derivative of the new stress by the strain increment with the old stress and state held: the consistent tangent of the
/// increment. The law's own code is differentiated, so that stress and tangent cannot disagree. On a kink of the law it is the derivative of the
/// side that the law takes; at the apex and in open soil it is 0. Not symmetric where flow is not associated. Where the stress across the plane
/// alone is cut off and those in the plane are equal to the last bit, the plane's deviator is given no stiffness; a hair beside, it has 2G.
template <class Prepared>
inline void update_stress_and_tangent(const Prepared& law, SymTensor<2>& stress, const Increment<2, Real>& increment, Real* state,
                                      Tangent& tangent)
{
  SymTensor<2, Dual> new_stress;
  Increment<2, Dual> with_slopes{{}, increment.dt, increment.time};
  SymTensor<2, Dual>& strain = with_slopes.strain;
  Dual new_state[std::max(Prepared::state_size, 1)];
  for (int k = 0; k < 4; ++k) {
    new_stress[k].value = stress[k];
    strain[k].value = increment.strain[k];
  }
  strain[0].slope[0] = 1;
  strain[1].slope[1] = 1;
  strain[3].slope[2] = 0.5;
  for (int k = 0; k < Prepared::state_size; ++k) new_state[k].value = state[k];

  update(law, new_stress, with_slopes, new_state);

  for (int k = 0; k < 4; ++k) {
    stress[k] = new_stress[k].value;
    for (int j = 0; j < 3; ++j) tangent(k, j) = new_stress[k].slope[j];
  }
  for (int k = 0; k < Prepared::state_size; ++k) state[k] = new_state[k].value;
}

}  // namespace berm::material
