// SPDX-License-Identifier: BSD-3-Clause
#include "structures/formulas/f109.hpp"

namespace berm::formulas {
namespace {

/// G = s_u/(gamma' D)
Real strength_ratio(const PipeInClay& pipe)
{
  return pipe.strength / (pipe.unit_weight * pipe.diameter);
}

bool is_clay(const PipeInClay& pipe)
{
  return pipe.diameter > 0 && pipe.unit_weight > 0 && pipe.strength > 0;
}

}  // namespace

Formula f109_sand_lateral(const PipeInSand& pipe, Real V)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "w >= 0, V >= 0; a limit is not given"};
  const Real weight = pipe.unit_weight * pipe.diameter * pipe.diameter, k = weight / V;
  const Real passive = weight * (k <= 20 ? 5 - 0.15 * k : 2) * std::pow(pipe.embedment / pipe.diameter, 1.25);
  return formula(0.6 * V + passive, source, pipe.diameter > 0 && pipe.unit_weight > 0 && pipe.embedment >= 0 && V >= 0);
}

Formula f109_clay_lateral(const PipeInClay& pipe, Real V)
{
  constexpr Source source{Label::recalled, "DNV-RP-F109, after Verley and Lund 1995", "w >= 0, V >= 0; a limit is not given"};
  const Real passive = 4.1 * pipe.diameter * pipe.strength * std::pow(strength_ratio(pipe), -0.39);
  return formula(0.2 * V + passive * std::pow(pipe.embedment / pipe.diameter, 1.31), source,
                 is_clay(pipe) && pipe.embedment >= 0 && V >= 0);
}

Formula f109_clay_embedment(const PipeInClay& pipe, Real V)
{
  constexpr Source source{Label::recalled, "DNV-RP-F109, after Verley and Lund 1995", "V >= 0; a limit is not given"};
  const Real x = std::pow(strength_ratio(pipe), 0.3) * V / (pipe.diameter * pipe.strength);
  return formula(pipe.diameter * (0.0071 * std::pow(x, 3.2) + 0.062 * std::pow(x, 0.7)), source, is_clay(pipe) && V >= 0);
}

}  // namespace berm::formulas
