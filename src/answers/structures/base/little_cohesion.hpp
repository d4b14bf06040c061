// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_queries.hpp"

namespace berm::base {

/// c cot(phi) over gamma' D up to which formulas for sand without cohesion hold. Cohesion acts as a further pressure c cot(phi) from all sides (Caquot 1934), so that
/// bearing capacity grows by 2 * 0.05 (N_q - 1) / N_gamma of D over the width in contact: at 33 deg by 7 % of a strip of width D on the surface, by 12 % of a
/// pipe at w = 0.1 D. Formulas differ by more: N_gamma of Vesic and of Brinch Hansen by 40 %.
constexpr Real little_cohesion = 0.05;

/// Whether formulas for sand without cohesion hold for a body of this width, m, in soil of this submerged unit weight, N/m3.
inline bool has_little_cohesion(Real cohesion, Real friction_angle, Real unit_weight, Real width)
{
  return cohesion <= little_cohesion * unit_weight * width * std::tan(friction_angle);
}

}  // namespace berm::base
