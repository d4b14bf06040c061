// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/axial.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr Source wedge{Label::exact, "White and Randolph 2007: normal stress as the cosine of the angle from the invert", "w > 0",
                       "also DNV-RP-F114 (2021), figure 4-12"};
constexpr Source interface {
  Label::exact, "shear strength over the length of the contact", "w > 0"
};
constexpr Source displacement{Label::fit, "DNVGL-RP-F114", "D > 0", "table 4-2"};

constexpr Source by_load{Label::fit, "DNV-RP-F114", "w > 0, V >= 0, 0 <= U <= 1", "with V the load under which the clay has consolidated"};

constexpr Real mm = 1e-3;

}  // namespace

Real contact_angle(Real diameter, Real embedment)
{
  return std::acos(std::clamp<Real>(1 - 2 * embedment / diameter, 0, 1));
}

Formula wedging_factor(Real diameter, Real embedment)
{
  const Real b = contact_angle(diameter, embedment), around = b + std::sin(b) * std::cos(b);
  return formula(b > 0 ? 2 * std::sin(b) / around : 1, wedge, embedment > 0);
}

Formula axial_drained(Real diameter, Real embedment, Real delta, Real V)
{
  return formula(wedging_factor(diameter, embedment).value * std::tan(delta) * V, wedge, embedment > 0);
}

Formula axial_undrained(Real diameter, Real embedment, Real strength)
{
  return formula(strength * diameter * contact_angle(diameter, embedment), interface, embedment > 0);
}

Formula axial_consolidated(Real diameter, Real embedment, Real V, Real U, const ConsolidatedInterface& clay)
{
  const Real strength = clay.roughness * clay.ratio * std::pow(std::max(clay.preload_ratio, Real(1)), clay.exponent);
  return formula(strength * wedging_factor(diameter, embedment).value * U * V, by_load, embedment > 0 && V >= 0 && within(U, 0, 1));
}

Formula skirt_friction(Real outer, Real inner, Real depth, Real strength)
{
  constexpr Source both_faces{Label::exact, "shear strength over both faces", "z > 0"};
  return formula(strength * pi * (outer + inner) * depth, both_faces, depth > 0 && outer > inner && inner > 0);
}

Estimates f114_axial_breakout_displacement(Real D)
{
  return estimates(std::min(1.25 * mm, 0.0025 * D), std::min(5 * mm, 0.01 * D), std::max(50 * mm, 0.01 * D), displacement, D > 0);
}

Estimates f114_axial_residual_displacement(Real D)
{
  return estimates(std::min(7.5 * mm, 0.015 * D), std::min(30 * mm, 0.06 * D), std::max(250 * mm, 0.5 * D), displacement, D > 0);
}

}  // namespace berm::formulas
