// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/axial.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr Source wedge{Label::exact, "White and Randolph 2007: normal stress as the cosine of the angle from the invert", "w > 0"};
constexpr Source interface {
  Label::exact, "shear strength over the length of the contact", "w > 0"
};

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

}  // namespace berm::formulas
