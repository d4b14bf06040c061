// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_sand.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace berm::formulas {
namespace {

constexpr std::array<Real, 4> table_embedment{0.05, 0.10, 0.25, 0.50};
constexpr std::array<Real, 4> table_smooth{1.433, 2.676, 5.980, 10.87};
constexpr std::array<Real, 4> table_frictional{3.100, 5.915, 13.37, 23.98};

/// V/(gamma' D^2) at w/D = x.
Real interpolated(const std::array<Real, 4>& table, Real x)
{
  const auto found = std::upper_bound(table_embedment.begin() + 1, table_embedment.end() - 1, x) - table_embedment.begin();
  const Real x0 = table_embedment[found - 1], x1 = table_embedment[found], y0 = table[found - 1], y1 = table[found];
  return y0 * std::pow(x / x0, std::log(y1 / y0) / std::log(x1 / x0));
}

Real weight_of(const PipeInSand& pipe)
{
  return pipe.unit_weight * pipe.diameter * pipe.diameter;
}

bool is_pipe(const PipeInSand& pipe)
{
  return pipe.diameter > 0 && pipe.unit_weight > 0;
}

}  // namespace

Formula sand_vertical(const PipeInSand& pipe)
{
  constexpr Source source{Label::exact, "characteristics, associated flow, table",
                          "phi = 35 deg, delta = 0 or 2/3 phi, 0.05 <= w/D <= 0.5"};
  const auto is = [](Real angle, Real wanted) { return std::abs(angle - wanted) < 0.02 * degree; };
  const bool smooth = is(pipe.interface_angle, 0), frictional = is(pipe.interface_angle, 70 * degree / 3);
  const Real x = pipe.embedment / pipe.diameter;
  if (!is(pipe.friction_angle, 35 * degree) || !(smooth || frictional)) return formula(nan, source, false);
  return formula(interpolated(smooth ? table_smooth : table_frictional, x) * weight_of(pipe), source,
                 is_pipe(pipe) && within(x, 0.05, 0.5));
}

Formula sand_embedment(const PipeInSand& pipe, Real V)
{
  constexpr Source source{Label::fit, "Verley and Sotberg 1994", "V >= 0; a limit is not given", "also DNV-RP-F109"};
  return formula(0.037 * pipe.diameter * std::pow(V / weight_of(pipe), 2. / 3), source, is_pipe(pipe) && V >= 0);
}

Formula zhang_envelope(const YieldSurface& surface, Real V, Real V_max)
{
  constexpr Source source{Label::recalled, "Zhang and others 1999, 2002", "0 <= V <= V_max"};
  return formula(surface.mu * (V / V_max + surface.beta) * (V_max - V), source, V_max > 0 && V >= 0 && V <= V_max);
}

// With v = V/V_max the surface is H/V_max = mu v (1 - v) + (mu beta)(1 - v): linear in mu and mu beta.
YieldSurface fit_zhang(std::span<const Real> V, std::span<const Real> H, Real V_max)
{
  assert(V.size() == H.size());
  Real aa = 0, ab = 0, bb = 0, ah = 0, bh = 0;
  for (std::size_t k = 0; k < V.size(); ++k) {
    const Real v = V[k] / V_max, h = H[k] / V_max, a = v * (1 - v), b = 1 - v;
    aa += a * a;
    ab += a * b;
    bb += b * b;
    ah += a * h;
    bh += b * h;
  }
  const Real determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-12 * aa * bb)) return {nan, nan};
  const Real mu = (ah * bb - bh * ab) / determinant, mu_beta = (bh * aa - ah * ab) / determinant;
  return {mu, mu_beta / mu};
}

Formula f109_sand_lateral(const PipeInSand& pipe, Real V)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "w >= 0, V >= 0; a limit is not given"};
  const Real weight = pipe.unit_weight * pipe.diameter * pipe.diameter, k = weight / V;
  const Real passive = weight * (k <= 20 ? 5 - 0.15 * k : 2) * std::pow(pipe.embedment / pipe.diameter, 1.25);
  return formula(0.6 * V + passive, source, pipe.diameter > 0 && pipe.unit_weight > 0 && pipe.embedment >= 0 && V >= 0);
}

}  // namespace berm::formulas
