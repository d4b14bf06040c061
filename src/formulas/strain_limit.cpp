// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/strain_limit.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr Source local_buckling{Label::fit, "DNV-OS-F101", "D/t <= 45, no external overpressure", "equation 5.30, displacement controlled"};
constexpr Real thinnest = 45;  // D/t

}  // namespace

Real f101_girth_weld_factor(Real diameter, Real wall)
{
  return 1 - std::max<Real>(0, diameter / wall - 20) / 100;
}

Formula f101_compressive_strain(Real diameter, Real wall, Real yield_over_tensile)
{
  const Real strain = 0.78 * (wall / diameter - 0.01) * std::pow(yield_over_tensile, -1.5) * f101_girth_weld_factor(diameter, wall);
  return formula(strain, local_buckling, diameter > 0 && within(diameter / wall, 2, thinnest) && yield_over_tensile > 0);
}

}  // namespace berm::formulas
