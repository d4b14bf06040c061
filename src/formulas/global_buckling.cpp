// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/global_buckling.hpp"

#include <algorithm>

namespace berm::formulas {

Formula curve_buckling_force(Real lateral, Real radius)
{
  constexpr Source source{Label::exact, "equilibrium of a curve", "h, R > 0"};
  return formula(lateral * radius, source, lateral > 0 && radius > 0);
}

Formula buckle_feed_in(Real constrained_force, Real compression, Real axial_stiffness, Real axial)
{
  constexpr Source source{Label::exact, "rigid friction along an elastic line", "EA, f > 0, P_0 >= P"};
  const Real released = constrained_force - compression;
  return formula(released * released / (axial_stiffness * axial), source, released >= 0 && axial_stiffness > 0 && axial > 0);
}

Formula palmer_download(Real P, Real EI, Real w_0, Real height)
{
  constexpr Source source{Label::fit, "Palmer and others 1990 (OTC 6335)", "P, EI, w_0, delta > 0; a limit is not given"};
  const Real value = (1.16 - 4.76 * std::sqrt(EI * w_0 / height) / P) * P * std::sqrt(height * w_0 / EI);
  return formula(std::max(value, Real(0)), source, P > 0 && EI > 0 && w_0 > 0 && height > 0);
}

Formula f114_lay_factor(Real Q_v, Real w, Real EI, Real T_0)
{
  constexpr Source source{Label::fit, "DNV-RP-F114 (2021)", "Q_v, w, EI, T_0 > 0"};
  return formula(0.6 + 0.4 * std::pow(Q_v * EI / (T_0 * T_0 * w), 0.25), source, Q_v > 0 && w > 0 && EI > 0 && T_0 > 0);
}

}  // namespace berm::formulas
