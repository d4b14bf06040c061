// SPDX-License-Identifier: BSD-3-Clause
#include "structures/formulas/f109.hpp"

namespace berm::formulas {
Formula f109_sand_lateral(const PipeInSand& pipe, Real V)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "w >= 0, V >= 0; a limit is not given"};
  const Real weight = pipe.unit_weight * pipe.diameter * pipe.diameter, k = weight / V;
  const Real passive = weight * (k <= 20 ? 5 - 0.15 * k : 2) * std::pow(pipe.embedment / pipe.diameter, 1.25);
  return formula(0.6 * V + passive, source, pipe.diameter > 0 && pipe.unit_weight > 0 && pipe.embedment >= 0 && V >= 0);
}

}  // namespace berm::formulas
