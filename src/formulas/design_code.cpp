// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/design_code.hpp"

#include "formulas/footing.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr Source f114(const char* range)
{
  return {Label::fit, "DNV-RP-F114", range};
}

constexpr Real root_2 = 1.41421356237309505;

}  // namespace

Real f114_contact_width(Real diameter, Real embedment)
{
  return embedment >= diameter / 2 ? diameter : 2 * std::sqrt(diameter * embedment - embedment * embedment);
}

Real f114_penetrated_area(Real diameter, Real embedment)
{
  if (embedment >= diameter / 2) return pi * diameter * diameter / 8 + diameter * (embedment - diameter / 2);
  const Real B = f114_contact_width(diameter, embedment), a = std::asin(B / diameter);
  return a * diameter * diameter / 4 - B * diameter / 4 * std::cos(a);
}

Formula f114_undrained_model_1(const PipeInClay& pipe, Real F)
{
  constexpr Source source = f114("s_u >= 0 at the surface, 0 <= w/D <= 1");
  const Real D = pipe.diameter, w = pipe.embedment, k = pipe.strength_gradient, N_c = 2 + pi, surface = pipe.strength - k * w;
  const bool in_range = D > 0 && within(w / D, 0, 1) && surface >= -1e-9 * pipe.strength && k >= 0 && F > 0;
  if (w == 0) return formula(0, source, in_range);
  const Real B = f114_contact_width(D, w);
  const Real z = w < D / 2 * (1 - root_2 / 2) ? 0 : w + D / 2 * (root_2 - 1) - B / 2;
  const Real s_u0 = surface + k * z, Q_v0 = F * (N_c * s_u0 + k * B / 4) * B;
  const Real s_u1 = (surface + s_u0) / 2, s_u2 = Q_v0 / (B * N_c), d = 0.3 * s_u1 / s_u2 * std::atan(z / B);
  return formula(Q_v0 * (1 + d) + pipe.unit_weight * f114_penetrated_area(D, w), source, in_range);
}

Formula f114_undrained_model_2(const PipeInClay& pipe)
{
  constexpr Source source = f114("0 <= w/D <= 0.5");
  const Real D = pipe.diameter, x = pipe.embedment / D;
  const Real factor = std::min(6 * std::pow(x, 0.25), 3.4 * std::sqrt(10 * x));
  const Real value = factor * D * pipe.strength + 1.5 * pipe.unit_weight * f114_penetrated_area(D, pipe.embedment);
  return formula(value, source, D > 0 && pipe.strength >= 0 && within(x, 0, 0.5));
}

Formula f114_drained_vertical(const PipeInSand& pipe)
{
  constexpr Source source = f114("15 <= phi <= 50 deg, 0 <= w/D <= 1");
  const Real D = pipe.diameter, w = pipe.embedment, phi = pipe.friction_angle, a = pi / 4 + phi / 2;
  const Formula N_gamma = n_gamma_hansen(phi);
  const bool in_range = D > 0 && pipe.unit_weight > 0 && N_gamma.valid && within(w / D, 0, 1);
  if (w == 0) return formula(0, source, in_range);
  const Real B = f114_contact_width(D, w);
  const Real z0 = w < D / 2 * (1 - std::cos(a)) ? 0 : w - D / 2 + (D / 2 / std::sin(a) - B / 2) * std::tan(a);
  const Real blocked = 1 - std::sin(phi), d_q = 1 + 1.2 * z0 / B * std::tan(phi) * blocked * blocked;
  return formula(pipe.unit_weight * B * (N_gamma.value * B / 2 + z0 * n_q(phi).value * d_q), source, in_range);
}

Formula f114_drained_lateral(const PipeInSand& pipe, Real V)
{
  constexpr Source source = f114("0 <= w/D <= 1, V >= 0");
  const Real K_p = (1 + std::sin(pipe.friction_angle)) / (1 - std::sin(pipe.friction_angle)), tan_delta = std::tan(pipe.interface_angle);
  const Real F_p = 0.5 * K_p * pipe.unit_weight * pipe.embedment * pipe.embedment;
  const bool in_range = pipe.diameter > 0 && pipe.unit_weight > 0 && within(pipe.embedment / pipe.diameter, 0, 1) && V >= 0;
  return formula(F_p + tan_delta * std::max(V - tan_delta * F_p, Real(0)), source, in_range);
}

Breakout f114_breakout(Real diameter, Real embedment)
{
  constexpr Source source = f114("0 <= w/D <= 1");
  const bool in_range = diameter > 0 && within(embedment / diameter, 0, 1);
  const auto line = [&](Real a, Real b) { return formula(a * diameter + b * embedment, source, in_range); };
  return {line(0.004, 0.02), line(0.02, 0.25), line(0.1, 0.7)};
}

}  // namespace berm::formulas
