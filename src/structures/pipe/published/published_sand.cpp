// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published/published_test.cpp
#include "structures/pipe/published/published_sand.hpp"

#include "structures/formulas/f109.hpp"
#include "structures/formulas/f114_lateral.hpp"
#include "structures/formulas/f114_vertical.hpp"

#include <fmt/format.h>

namespace berm::pipe {
namespace {

bool is_associated(const SandAround& sand)
{
  return std::abs(sand.friction_angle - sand.dilation_angle) < 0.02 * degree;
}

}  // namespace

std::vector<Comparison> sand_in_push(const SandAround& sand, Real w, Real V)
{
  const formulas::PipeInSand pipe = sand.at(w);
  formulas::Formula characteristics = sand_vertical(pipe);
  if (!is_associated(sand)) {
    characteristics.valid = false;
    characteristics.source.range = "phi = psi = 35 deg, delta = 0 or 2/3 phi, 0.05 <= w/D <= 0.5";
  }
  return {{"V", Comparison::Unit::force, V, f114_drained_vertical(pipe), "bearing capacity with Nγ of Brinch Hansen, wished in place"},
          {"V", Comparison::Unit::force, V, f114_drained_vertical(pipe, formulas::SelfWeight::vesic),
           "bearing capacity with Nγ of Vesic, wished in place"},
          {"V", Comparison::Unit::force, V, characteristics, "wished in place"},
          {"w under this V", Comparison::Unit::length, w, sand_embedment(pipe, V), ""}};
}

std::vector<Comparison> sand_in_drag(const SandAround& sand, Real w, Real V, Real H)
{
  const formulas::PipeInSand pipe = sand.at(w);
  return {{"H", Comparison::Unit::force, H, f114_drained_lateral(pipe, V), "passive wedge and friction, Kp with δ"},
          {"H", Comparison::Unit::force, H, f114_drained_lateral(pipe, V, formulas::PassiveAngle::soil), "the same, Kp with φ"},
          {"H", Comparison::Unit::force, H, f109_sand_lateral(pipe, V), ""}};
}

std::vector<Comparison> sand_after_sweep(const SandAround& sand, Real w, Real V, Real H)
{
  return {{"H", Comparison::Unit::force, H, f114_drained_lateral(sand.at(w), V), "residual, as breakout at this embedment"}};
}

std::vector<std::string> remarks_on(const SandAround& sand)
{
  std::vector<std::string> remarks;
  if (!is_associated(sand))
    remarks.push_back(fmt::format("The characteristics are for associated soil, ψ = φ, which carries more. The sand of this run has φ = "
                                  "{:.3g}° and dilates by ψ = {:.3g}°.",
                                  sand.friction_angle / degree, sand.dilation_angle / degree));
  if (sand.cohesion > 0)
    remarks.push_back(
        fmt::format("The formulas are for sand without cohesion. The sand of this run has c = {:.3g} Pa, {:.2g} γ' D: without "
                    "it they are too low, by more the smaller w is.",
                    sand.cohesion, sand.cohesion / (sand.unit_weight * sand.diameter)));
  return remarks;
}

}  // namespace berm::pipe
