// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/rebound.hpp"

namespace berm::formulas {

Formula pipe_rebound_stiffness(Real shear_modulus, Real poisson_ratio)
{
  constexpr Source source{Label::fit, "DNV Guideline 14 (1998)", "G > 0, 0 <= nu <= 0.5", "0.88 G/(1 - nu)"};
  return formula(0.88 * shear_modulus / (1 - poisson_ratio), source, shear_modulus > 0 && within(poisson_ratio, 0, 0.5));
}

}  // namespace berm::formulas
