// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/f114.hpp"

#include "formulas/footing.hpp"

#include <algorithm>
#include <array>

namespace berm::formulas {
namespace {

// Editions are those that the public programs name beside section or equation; DNVGL without a year: they name none.
constexpr Source f114_of(const char* edition, const char* range, const char* clause)
{
  return {Label::fit, edition, range, clause};
}
constexpr const char *dnvgl = "DNVGL-RP-F114", *of_2019 = "DNVGL-RP-F114 (2019)", *of_2021 = "DNV-RP-F114 (2021)";

constexpr Real root_2 = 1.41421356237309505;

/// F at x = k B/s_u0.
constexpr std::array<Real, 6> factor_x{0, 1, 2, 4, 8, 16};
constexpr std::array<Real, 6> factor_smooth{1, 1.110, 1.181, 1.273, 1.370, 1.448};
constexpr std::array<Real, 6> factor_rough{1, 1.226, 1.346, 1.486, 1.621, 1.736};

Real factor_at(const std::array<Real, 6>& table, Real x)
{
  const auto k = std::upper_bound(factor_x.begin() + 1, factor_x.end() - 1, x) - factor_x.begin();
  const Real from = std::log1p(factor_x[k - 1]), to = std::log1p(factor_x[k]);
  return std::lerp(table[k - 1], table[k], (std::log1p(x) - from) / (to - from));
}

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

Formula f114_strength_factor(Real x, Real roughness)
{
  constexpr Source source = f114_of(dnvgl, "0 <= k B/s_u0 <= 16", "figure 4-4, after Davis and Booker 1973");
  if (x == 0) return formula(1, source, true);
  if (!(x > 0)) return formula(nan, source, false);
  return formula(std::lerp(factor_at(factor_smooth, x), factor_at(factor_rough, x), roughness), source,
                 within(x, 0, 16) && within(roughness, 0, 1));
}

Formula f114_undrained_model_1(const PipeInClay& pipe, Real N_c)
{
  constexpr Source source = f114_of(of_2019, "s_u >= 0 at the surface, k B/s_u0 <= 16, 0 <= w/D <= 1", "equations 4.1 and 4.2");
  const Real D = pipe.diameter, w = pipe.embedment, k = pipe.strength_gradient, surface = pipe.strength - k * w;
  const bool in_range = D > 0 && within(w / D, 0, 1) && surface >= -1e-9 * pipe.strength && k >= 0;
  if (w == 0) return formula(0, source, in_range);
  const Real B = f114_contact_width(D, w);
  const Real z = w < D / 2 * (1 - root_2 / 2) ? 0 : w + D / 2 * (root_2 - 1) - B / 2;
  const Real s_u0 = surface + k * z;
  const Formula F = f114_strength_factor(k == 0 ? 0 : k * B / s_u0, pipe.roughness);
  const Real Q_v0 = F.value * (N_c * s_u0 + k * B / 4) * B;
  const Real s_u1 = (surface + s_u0) / 2, s_u2 = Q_v0 / (B * N_c), d = 0.3 * s_u1 / s_u2 * std::atan(z / B);
  return formula(Q_v0 * (1 + d) + pipe.unit_weight * f114_penetrated_area(D, w), source, in_range && F.valid && N_c > 0);
}

Formula f114_undrained_model_2(const PipeInClay& pipe)
{
  constexpr Source source = f114_of(of_2021, "0 <= w/D <= 0.5", "equation 4.8");
  const Real D = pipe.diameter, x = pipe.embedment / D;
  const Real factor = std::min(6 * std::pow(x, 0.25), 3.4 * std::sqrt(10 * x));
  const Real value = factor * D * pipe.strength + 1.5 * pipe.unit_weight * f114_penetrated_area(D, pipe.embedment);
  return formula(value, source, D > 0 && pipe.strength >= 0 && within(x, 0, 0.5));
}

Formula f114_drained_vertical(const PipeInSand& pipe, SelfWeight self_weight)
{
  constexpr Source source = f114_of(of_2019, "15 <= phi <= 50 deg, 0 <= w/D <= 1", "equation 4.9");
  const Real D = pipe.diameter, w = pipe.embedment, phi = pipe.friction_angle, a = pi / 4 + phi / 2;
  const Formula N_gamma = self_weight == SelfWeight::hansen ? n_gamma_hansen(phi) : n_gamma_vesic(phi);
  const bool in_range = D > 0 && pipe.unit_weight > 0 && N_gamma.valid && within(w / D, 0, 1);
  if (w == 0) return formula(0, source, in_range);
  const Real B = f114_contact_width(D, w);
  const Real z0 = w < D / 2 * (1 - std::cos(a)) ? 0 : w - D / 2 + (D / 2 / std::sin(a) - B / 2) * std::tan(a);
  const Real blocked = 1 - std::sin(phi), d_q = 1 + 1.2 * z0 / B * std::tan(phi) * blocked * blocked;
  return formula(pipe.unit_weight * B * (N_gamma.value * B / 2 + z0 * n_q(phi).value * d_q), source, in_range);
}

}  // namespace berm::formulas
