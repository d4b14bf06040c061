// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dual.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

#include <algorithm>

namespace berm::material {

/// d(s_xx, s_yy, s_zz, s_xy) / d(e_xx, e_yy, gamma_xy) of plane strain, gamma_xy = 2 e_xy, Pa. Rows 0, 1 and 3 multiply the
/// B-matrix of finite elements.
using Tangent = Eigen::Matrix<Real, 4, 3, Eigen::DontAlign>;

/// Updates the stress and gives the consistent tangent: the derivative of the new stress with respect to the strain
/// increment at fixed old stress and state, by automatic differentiation of the law. At a corner of the yield surface it is
/// that of the side which the return takes; at the apex and in open soil it is 0. Non-symmetric where flow is
/// non-associated. Where only the out-of-plane stress is cut off and the in-plane principal stresses are bitwise equal, the
/// in-plane deviatoric stiffness is 0 instead of 2G. `across` gets d(s_xx, s_yy, s_zz, s_xy) / d e_zz, Pa, of strains that have one, as around an axis.
template <class Prepared>
inline void update_stress_and_tangent(const Prepared& law, SymTensor<2>& stress, const Increment<2, Real>& increment, Real* state,
                                      Tangent& tangent, SymTensor<2>* across = nullptr)
{
  SymTensor<2, Dual> new_stress;
  Increment<2, Dual> with_slopes{{}, increment.dt, increment.time, increment.cell_size};
  SymTensor<2, Dual>& strain = with_slopes.strain;
  Dual new_state[std::max(Prepared::state_size, 1)];
  for (int k = 0; k < 4; ++k) {
    new_stress[k].value = stress[k];
    strain[k].value = increment.strain[k];
  }
  strain[0].slope[0] = 1;
  strain[1].slope[1] = 1;
  strain[2].slope[3] = 1;
  strain[3].slope[2] = 0.5;
  const int state_variables = state_count(law);
  for (int k = 0; k < state_variables; ++k) new_state[k].value = state[k];

  update(law, new_stress, with_slopes, new_state);

  for (int k = 0; k < 4; ++k) {
    stress[k] = new_stress[k].value;
    for (int j = 0; j < 3; ++j) tangent(k, j) = new_stress[k].slope[j];
    if (across != nullptr) (*across)[k] = new_stress[k].slope[3];
  }
  for (int k = 0; k < state_variables; ++k) state[k] = new_state[k].value;
}

/// d(s_xx, s_yy, s_zz, s_xy, s_yz, s_xz) / d(e_xx, e_yy, e_zz, gamma_xy, gamma_yz, gamma_xz), gamma = 2 e, Pa.
using TangentInSpace = Eigen::Matrix<Real, 6, 6, Eigen::DontAlign>;

/// The same in space, in two updates: a Dual has four derivatives.
template <class Prepared>
inline void update_stress_and_tangent(const Prepared& law, SymTensor<3>& stress, const Increment<3, Real>& increment, Real* state,
                                      TangentInSpace& tangent)
{
  SymTensor<3, Dual> new_stress;
  Dual new_state[std::max(Prepared::state_size, 1)];
  const int state_variables = state_count(law);
  for (const int first : {0, 4}) {
    const int end = std::min(first + 4, 6);
    Increment<3, Dual> with_slopes{{}, increment.dt, increment.time, increment.cell_size};
    for (int k = 0; k < 6; ++k) {
      new_stress[k] = {stress[k]};
      with_slopes.strain[k].value = increment.strain[k];
    }
    for (int j = first; j < end; ++j) with_slopes.strain[j].slope[j - first] = j < 3 ? 1 : 0.5;
    for (int k = 0; k < state_variables; ++k) new_state[k] = {state[k]};

    update(law, new_stress, with_slopes, new_state);

    for (int k = 0; k < 6; ++k)
      for (int j = first; j < end; ++j) tangent(k, j) = new_stress[k].slope[j - first];
  }
  for (int k = 0; k < 6; ++k) stress[k] = new_stress[k].value;
  for (int k = 0; k < state_variables; ++k) state[k] = new_state[k].value;
}

}  // namespace berm::material
