// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/uplift.hpp"

#include "formulas/footing.hpp"
#include "formulas/pipe_in_clay.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr const char* block_range = "level sand, 0 <= psi <= phi, normal stress on the planes as at rest";
constexpr Source inclined{Label::exact, "block between planes at psi to the vertical; White, Cheuk and Bolton 2008", block_range};
constexpr Source upright{Label::exact, "block between vertical planes", block_range};
constexpr Source f110{Label::fit, "DNV-RP-F110 (2007)", "level sand, cover > 0; f = K_0 tan phi", "equation B.3"};
constexpr Source f114{Label::fit, "DNVGL-RP-F114", "level sand, cover > 0; f of loose, medium and dense sand", "equation 5.6"};
constexpr Source alliance{Label::fit, "American Lifelines Alliance 2001", "cover > 0; a limit is not given"};
constexpr Source otc{Label::fit, "OTC 6486", "uniform s_u, cover > 0; a limit is not given", "equation 7"};

Real k0_of(const BuriedPipe& pipe)
{
  return pipe.k0.value_or(1 - std::sin(pipe.friction_angle));
}

bool is_buried(const BuriedPipe& pipe)
{
  return pipe.diameter > 0 && pipe.cover > 0 && pipe.unit_weight >= 0;
}

bool in_sand(const BuriedPipe& pipe)
{
  return is_buried(pipe) && pipe.friction_angle > 0 && pipe.friction_angle < pi / 2;
}

bool in_clay(const BuriedPipe& pipe)
{
  return is_buried(pipe) && pipe.friction_angle == 0 && pipe.strength > 0;
}

/// gamma' H^2
Real deep_weight(const BuriedPipe& pipe)
{
  return pipe.unit_weight * pipe.depth() * pipe.depth();
}

/// Weight of the sand above the upper half of the pipe.
Real weight_above(const BuriedPipe& pipe)
{
  const Real D = pipe.diameter;
  return pipe.unit_weight * (pipe.depth() * D - pi * D * D / 8);
}

Real slip(const BuriedPipe& pipe, Real psi)
{
  const Real K0 = k0_of(pipe), at_rest = (1 + K0) / 2 - (1 - K0) / 2 * std::cos(2 * psi);
  return weight_above(pipe) + deep_weight(pipe) * (std::tan(psi) + (std::tan(pipe.friction_angle) - std::tan(psi)) * at_rest);
}

}  // namespace

Formula uplift_inclined_slip(const BuriedPipe& pipe)
{
  return formula(slip(pipe, pipe.dilation_angle), inclined, in_sand(pipe) && within(pipe.dilation_angle, 0, pipe.friction_angle));
}

Formula uplift_vertical_slip(const BuriedPipe& pipe)
{
  return formula(slip(pipe, 0), upright, in_sand(pipe));
}

Formula f110_uplift(const BuriedPipe& pipe)
{
  const Real f = k0_of(pipe) * std::tan(pipe.friction_angle);
  return formula(pipe.unit_weight * pipe.depth() * pipe.diameter + f * deep_weight(pipe), f110, in_sand(pipe));
}

Formula f114_uplift(const BuriedPipe& pipe, Packing packing)
{
  const Real f = packing == Packing::loose ? 0.29 : packing == Packing::medium ? 0.47 : 0.62, D = pipe.diameter;
  return formula(pipe.unit_weight * (pipe.cover * D + D * D * (0.5 - pi / 8)) + f * deep_weight(pipe), f114, in_sand(pipe));
}

Formula ala_uplift_sand(const BuriedPipe& pipe)
{
  const Real over_D = pipe.depth() / pipe.diameter;
  const Real N = std::min(pipe.friction_angle / (44 * degree) * over_D, n_q(pipe.friction_angle).value);
  return formula(N * pipe.unit_weight * pipe.depth() * pipe.diameter, alliance, in_sand(pipe));
}

Formula ala_uplift_clay(const BuriedPipe& pipe)
{
  return formula(std::min(2 * pipe.depth() / pipe.diameter, Real(10)) * pipe.strength * pipe.diameter, alliance, in_clay(pipe));
}

Formula otc_uplift_clay(const BuriedPipe& pipe)
{
  return formula(pipe.depth() * (pipe.unit_weight * pipe.diameter + 2 * pipe.strength), otc, in_clay(pipe));
}

Estimates ala_uplift_displacement(const BuriedPipe& pipe)
{
  const bool sand = pipe.friction_angle > 0;
  const Real part = sand ? 0.01 : 0.1, most = (sand ? 0.1 : 0.2) * pipe.diameter;
  const Real low = std::min(part * pipe.depth(), most), high = std::min(2 * part * pipe.depth(), most);
  return estimates(low, (low + high) / 2, high, alliance, is_buried(pipe));
}

std::vector<UpliftModel> uplift_models(const BuriedPipe& pipe)
{
  if (pipe.friction_angle > 0)
    return {{"inclined slip planes", uplift_inclined_slip(pipe)},
            {"vertical slip planes", uplift_vertical_slip(pipe)},
            {"F110, f = K0 tan phi", f110_uplift(pipe)},
            {"F114, loose sand", f114_uplift(pipe, Packing::loose)},
            {"F114, medium sand", f114_uplift(pipe, Packing::medium)},
            {"F114, dense sand", f114_uplift(pipe, Packing::dense)},
            {"ALA, sand", ala_uplift_sand(pipe)}};
  if (!(pipe.strength > 0)) return {};
  return {{"weight and shear on vertical planes", otc_uplift_clay(pipe)},
          {"ALA, clay", ala_uplift_clay(pipe)},
          {"soil flows around the pipe", clay_deep({pipe.diameter, pipe.cover + pipe.diameter, pipe.strength, pipe.roughness})}};
}

}  // namespace berm::formulas
