// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/f114.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

// The public program that names sections and tables names no edition.
constexpr Source f114_section(const char* range, const char* clause, Label label = Label::fit)
{
  return {label, "DNVGL-RP-F114", range, clause};
}

constexpr Real low_pressure = 2, high_pressure = 2.5;

}  // namespace

Estimates f114_undrained_lateral_1(const PipeInClay& pipe, Rear rear)
{
  constexpr Source source = f114_section("s_u >= 0 at the surface, 0 <= w/D <= 1", "4.4.2.2");
  const Real D = pipe.diameter, w = pipe.embedment, k = pipe.strength_gradient, height = std::min(w, D);
  const Real friction = pipe.roughness * pipe.strength * f114_contact_width(D, w), s_u = pipe.strength - k * height / 2;
  const bool in_range = D > 0 && within(w / D, 0, 1) && pipe.strength - k * w >= -1e-9 * pipe.strength && within(pipe.roughness, 0, 1);
  const auto H = [&](Real c) { return friction + height * (rear == Rear::gap ? c * s_u + pipe.unit_weight * w / 2 : 2 * c * s_u); };
  return estimates(H(low_pressure), H((low_pressure + high_pressure) / 2), H(high_pressure), source, in_range);
}

Formula f114_undrained_lateral_2(const PipeInClay& pipe, Real V)
{
  constexpr Source source{Label::fit, "DNV-RP-F114 (2021)", "0 <= w/D <= 1, V >= 0", "equation 4.22"};
  const Real D = pipe.diameter, x = pipe.embedment / D, D_su = D * pipe.strength;
  const Real value = D_su * (1.7 * std::pow(x, 0.61) + 0.23 * std::pow(V / D_su, 0.83)) + 0.6 * pipe.unit_weight * D * D * x * x;
  return formula(value, source, D > 0 && pipe.strength > 0 && within(x, 0, 1) && V >= 0);
}

Formula f114_drained_lateral(const PipeInSand& pipe, Real V, PassiveAngle angle)
{
  const bool of_interface = angle == PassiveAngle::interface;
  const Source source = f114_section("0 <= w/D <= 1, V >= 0", "4.4.2.3", of_interface ? Label::fit : Label::recalled);
  const Real s = std::sin(of_interface ? pipe.interface_angle : pipe.friction_angle), tan_delta = std::tan(pipe.interface_angle);
  const Real F_p = 0.5 * (1 + s) / (1 - s) * pipe.unit_weight * pipe.embedment * pipe.embedment;
  const bool in_range = pipe.diameter > 0 && pipe.unit_weight > 0 && within(pipe.embedment / pipe.diameter, 0, 1) && V >= 0;
  return formula(F_p + tan_delta * std::max(V - tan_delta * F_p, Real(0)), source, in_range);
}

Estimates f114_clay_residual(const PipeInClay& pipe, Real V)
{
  constexpr Source source{Label::fit, "DNV-RP-F114", "0 < V <= 2 D s_u, sweeps of some D"};
  const Real best = V * (0.32 + 0.8 * std::pow(pipe.embedment / pipe.diameter, 0.8));
  const bool in_range = pipe.diameter > 0 && pipe.embedment > 0 && V > 0 && V <= 2 * pipe.diameter * pipe.strength;
  return estimates(best / 1.5, best, best * 1.5, source, in_range);
}

Estimates f114_breakout_displacement(Real diameter, Real embedment)
{
  constexpr Source source = f114_section("0 <= w/D <= 1", "table 4-4");
  const auto line = [&](Real a, Real b) { return a * diameter + b * embedment; };
  return estimates(line(0.004, 0.02), line(0.02, 0.25), line(0.1, 0.7), source, diameter > 0 && within(embedment / diameter, 0, 1));
}

Estimates f114_residual_displacement(Real diameter)
{
  constexpr Source source = f114_section("sweeps of some D", "table 4-5");
  return estimates(0.6 * diameter, 1.5 * diameter, 2.8 * diameter, source, diameter > 0);
}

}  // namespace berm::formulas
