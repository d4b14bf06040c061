// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published_uplift_test.cpp
#include "formulas/uplift.hpp"
#include "structures/pipe/published_of_soil.hpp"

#include <algorithm>

namespace berm::pipe {
namespace {

formulas::BuriedPipe buried_in(const SandAround& sand, Real w)
{
  return {.diameter = sand.diameter,
          .cover = w - sand.diameter,
          .unit_weight = sand.unit_weight,
          .friction_angle = sand.friction_angle,
          .dilation_angle = sand.dilation_angle};
}

/// With the mean strength over the cover.
formulas::BuriedPipe buried_in(const ClayAround& clay, Real w)
{
  const formulas::PipeInClay crown = clay.at(w - clay.diameter), surface = clay.at(0);
  const Real roughness = clay.at(w).roughness;
  return {.diameter = clay.diameter,
          .cover = w - clay.diameter,
          .unit_weight = clay.unit_weight,
          .strength = (surface.strength + crown.strength) / 2,
          .roughness = std::isnan(roughness) ? 0 : std::min(Real(1), roughness)};
}

}  // namespace

std::vector<Comparison> in_uplift(const PipeSoil& soil, Real w, Real R, Real travel)
{
  std::vector<Comparison> list;
  formulas::BuriedPipe pipe{};
  if (const auto* sand = std::get_if<SandAround>(&soil)) pipe = buried_in(*sand, w);
  if (const auto* clay = std::get_if<ClayAround>(&soil)) pipe = buried_in(*clay, w);
  if (!(pipe.diameter > 0) || !(pipe.cover > 0)) return list;
  for (const formulas::UpliftModel& model : uplift_models(pipe))
    list.push_back({"R", Comparison::Unit::force, R, model.resistance, model.name});
  if (list.empty()) return list;
  for (Comparison& u : with_estimates("u at R", Comparison::Unit::length, travel, ala_uplift_displacement(pipe), ""))
    list.push_back(std::move(u));
  return list;
}

}  // namespace berm::pipe
