// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_clay.hpp"

namespace berm::formulas {
namespace {

Real relative_embedment(const PipeInClay& pipe)
{
  return pipe.embedment / pipe.diameter;
}

/// Uniform strength, embedment of at most D/2.
bool in_common_range(const PipeInClay& pipe)
{
  return pipe.diameter > 0 && pipe.strength >= 0 && pipe.strength_gradient == 0 && within(relative_embedment(pipe), 0, 0.5) &&
         within(pipe.roughness, 0, 1);
}

/// a (w/D)^p D s_u
struct Power {
  Real a, p;
  Real of(const PipeInClay& pipe) const { return a * std::pow(relative_embedment(pipe), p) * pipe.diameter * pipe.strength; }
};

Real between(const Power& smooth, const Power& rough, const PipeInClay& pipe)
{
  return std::lerp(smooth.of(pipe), rough.of(pipe), pipe.roughness);
}

struct Exponents {
  Real b1, b2;
};

Exponents envelope_exponents(const PipeInClay& pipe)
{
  const Real w = relative_embedment(pipe);
  return {(0.8 - 0.15 * pipe.roughness) * (1.2 - w), 0.35 * (2.5 - w)};
}

constexpr const char* common_range = "uniform s_u, 0 <= w/D <= 0.5";

}  // namespace

Formula clay_vertical_smooth(const PipeInClay& pipe)
{
  const bool is_exact = relative_embedment(pipe) <= clay_slip_lines_exact_to;
  const Source source{is_exact ? Label::exact : Label::lower_bound, "slip lines, weightless clay",
                      is_exact ? "smooth, uniform s_u, 0 <= w/D <= 0.146" : "smooth, uniform s_u, 0.146 < w/D <= 0.5: V is this or more"};
  const Real theta = std::acos(1 - 2 * relative_embedment(pipe));
  const Real factor = (2 + pi - 2 * theta) * std::sin(theta) + 2 * (1 - std::cos(theta));
  return formula(factor * pipe.diameter * pipe.strength, source, in_common_range(pipe) && pipe.roughness == 0);
}

Formula clay_vertical(const PipeInClay& pipe)
{
  constexpr Source source{Label::fit, "Merifield, White and Randolph 2008", common_range};
  return formula(between({5.66, 0.32}, {7.40, 0.40}, pipe), source, in_common_range(pipe));
}

Formula clay_horizontal(const PipeInClay& pipe)
{
  constexpr Source source{Label::fit, "Merifield, White and Randolph 2008", common_range};
  return formula(between({2.72, 0.78}, {3.26, 0.82}, pipe), source, in_common_range(pipe));
}

Formula clay_envelope(const PipeInClay& pipe, Real V, Real V_max, Real H_max)
{
  constexpr Source source{Label::fit, "Merifield, White and Randolph 2008", "uniform s_u, 0 <= w/D <= 0.5, 0 <= V <= V_max"};
  const auto [b1, b2] = envelope_exponents(pipe);
  const Real b = std::pow(b1 + b2, b1 + b2) / (std::pow(b1, b1) * std::pow(b2, b2)), v = V / V_max;
  return formula(H_max * b * std::pow(v, b1) * std::pow(1 - v, b2), source, in_common_range(pipe) && V_max > 0 && v >= 0 && v <= 1);
}

Formula clay_vertical_with_heave(const PipeInClay& pipe)
{
  constexpr Source source{Label::recalled, "Merifield, White and Randolph 2009", common_range};
  return formula(between({5.3, 0.25}, {7.1, 0.33}, pipe), source, in_common_range(pipe));
}

Formula clay_deep(const PipeInClay& pipe)
{
  const bool ends = pipe.roughness == 0 || pipe.roughness == 1;
  const Source source{ends ? Label::exact : Label::recalled, "Randolph and Houlsby 1984",
                      "uniform s_u, so deep that the soil flows around the pipe: w > D at least"};
  const Real d = std::asin(pipe.roughness), half = (pi / 2 - d) / 2;
  const Real factor = pi + 2 * d + 4 * std::cos(half) * (std::sqrt(2.) + std::sin(half));
  const bool in_range = pipe.diameter > 0 && pipe.strength >= 0 && pipe.strength_gradient == 0 && pipe.embedment > pipe.diameter;
  return formula(factor * pipe.diameter * pipe.strength, source, in_range);
}

namespace {

constexpr Source safebuck{Label::fit, "SAFEBUCK design guideline", "large sweeps, w/D > 0, V > 0", "C.6.4.1"};

constexpr Source white_and_cheuk(const char* range, const char* clause)
{
  return {Label::fit, "White and Cheuk 2008", range, clause};
}

Estimates between(Real low, Real high, bool in_range)
{
  return estimates(low, (low + high) / 2, high, safebuck, in_range);
}

bool has_place(const PipeInClay& pipe)
{
  return pipe.diameter > 0 && pipe.embedment > 0 && pipe.strength > 0;
}

}  // namespace

Formula clay_residual(const PipeInClay& pipe, Real V)
{
  constexpr Source source = white_and_cheuk("clay with weight, V > 0, sweeps of some D", "equation 3");
  const Real strength = pipe.strength / (2 * pipe.unit_weight * pipe.diameter);
  return formula(V * (1 - 0.65 * -std::expm1(-strength)), source, has_place(pipe) && pipe.unit_weight > 0 && V > 0);
}

Estimates safebuck_mid_sweep(const PipeInClay& pipe, Real V)
{
  const Real w = pipe.embedment / pipe.diameter;
  return between(V * (0.25 + 0.3 * std::max(Real(0), w - 0.8)), V * (0.9 + 1.5 * std::max(Real(0), w - 0.7)), has_place(pipe) && V > 0);
}

Estimates safebuck_berm(const PipeInClay& pipe)
{
  const Real w = pipe.embedment / pipe.diameter, D_su = pipe.diameter * pipe.strength;
  return between(0.9 * w * D_su, 4.5 * std::pow(w, 0.4) * D_su, has_place(pipe));
}

}  // namespace berm::formulas
