// SPDX-License-Identifier: BSD-3-Clause
#include "structures/formulas/clay_sweeps.hpp"

namespace berm::formulas {
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
