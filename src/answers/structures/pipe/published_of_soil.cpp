// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published_test.cpp
#include "structures/pipe/published_of_soil.hpp"

#include "formulas/f114.hpp"
#include "formulas/pipe_in_clay.hpp"
#include "formulas/pipe_in_sand.hpp"
#include "material/clay.hpp"

#include <fmt/format.h>

namespace berm::pipe {
namespace {

/// What the clay that the pipe displaces weighs, N/m: the formulas from strength alone leave it out.
Real buoyancy_of(const formulas::PipeInClay& pipe)
{
  return pipe.unit_weight > 0 ? pipe.unit_weight * formulas::f114_penetrated_area(pipe.diameter, pipe.embedment) : 0;
}

formulas::Formula with_buoyancy(formulas::Formula strength_alone, const formulas::PipeInClay& pipe)
{
  strength_alone.value += buoyancy_of(pipe);
  return strength_alone;
}

formulas::Formula bound(Real factor, const formulas::PipeInClay& pipe)
{
  return with_buoyancy(formulas::formula(factor * pipe.diameter * pipe.strength, formulas::murff_source, pipe.strength_gradient == 0),
                       pipe);
}

}  // namespace

std::vector<Comparison> clay_in_push(const ClayAround& clay, Real w, Real V, bool heaves)
{
  const formulas::PipeInClay pipe = clay.at(w);
  std::vector<Comparison> list;
  const auto add = [&](const formulas::Formula& published, const char* about) {
    list.push_back({"V", Comparison::Unit::force, V, published, about});
  };
  if (pipe.strength_gradient == 0 || !std::isnan(pipe.roughness))
    add(f114_undrained_model_1(pipe), "model 1, bearing capacity, wished in place");
  add(f114_undrained_model_2(pipe), "model 2, with heave");
  if (std::isnan(pipe.roughness)) return list;
  add(with_buoyancy(clay_vertical(pipe), pipe), "wished in place");
  if (heaves) add(with_buoyancy(clay_vertical_with_heave(pipe), pipe), "with heave");
  if (pipe.roughness == 0) add(with_buoyancy(clay_vertical_smooth(pipe), pipe), "wished in place");
  const bool ends = pipe.roughness == 0 || pipe.roughness == 1;
  if (ends && std::abs(w / pipe.diameter - 0.5) < 0.005) {
    const formulas::MurffBounds& bounds = pipe.roughness == 0 ? formulas::murff_smooth : formulas::murff_rough;
    add(bound(bounds.lower, pipe), "lower, wished in place");
    add(bound(bounds.upper, pipe), "upper, wished in place");
  }
  add(with_buoyancy(clay_deep(pipe), pipe), "deeply buried: the largest resistance to a pipe");
  return list;
}

std::vector<Comparison> clay_in_drag(const ClayAround& clay, Real w, Real V, Real H)
{
  const formulas::PipeInClay pipe = clay.at(w);
  if (std::isnan(pipe.roughness)) return {};
  const formulas::Formula V_max = clay_vertical(pipe), H_max = clay_horizontal(pipe);
  const formulas::Formula at_V = clay_envelope(pipe, V - buoyancy_of(pipe), V_max.value, H_max.value);
  return {{"H", Comparison::Unit::force, H, at_V, "envelope at the run's V, wished in place"},
          {"H", Comparison::Unit::force, H, H_max, "apex of the envelope, wished in place"},
          {"H", Comparison::Unit::force, H, clay_deep(pipe), "deeply buried: the largest resistance to a pipe"}};
}

std::vector<Comparison> clay_at_breakout(const ClayAround& clay, Real w, Real V, Real H)
{
  const formulas::PipeInClay pipe = clay.at(w);
  std::vector<Comparison> list;
  if (!std::isnan(pipe.roughness)) {
    const formulas::Rear rear = clay.suction ? formulas::Rear::suction : formulas::Rear::gap;
    list = with_estimates("H", Comparison::Unit::force, H, f114_undrained_lateral_1(pipe, rear),
                          clay.suction ? "model 1, with suction behind the pipe" : "model 1, without suction behind the pipe");
  }
  list.push_back({"H", Comparison::Unit::force, H, f114_undrained_lateral_2(pipe, V), "model 2"});
  return list;
}

namespace {

void append(std::vector<Comparison>& list, const std::vector<Comparison>& more)
{
  list.insert(list.end(), more.begin(), more.end());
}

constexpr const char *residual = "residual H", *against_a_berm = "H against a berm";

/// Of a guideline whose best estimate is only the mean of both.
void append_ends(std::vector<Comparison>& list, const char* quantity, Real berm, const formulas::Estimates& estimates,
                 const std::string& about)
{
  std::vector<Comparison> three = with_estimates(quantity, Comparison::Unit::force, berm, estimates, about);
  three.erase(three.begin() + 1);
  append(list, three);
}

}  // namespace

std::vector<Comparison> clay_after_sweep(const ClayAround& clay, const SweepResults& sweep)
{
  const formulas::PipeInClay pipe = clay.at(sweep.w_begin);
  std::vector<Comparison> list = {{residual, Comparison::Unit::force, sweep.residual, clay_residual(pipe, sweep.V), "residual"}};
  append(list, with_estimates(residual, Comparison::Unit::force, sweep.residual, f114_clay_residual(pipe, sweep.V), "residual"));
  return list;
}

std::vector<Comparison> clay_between_berms(const ClayAround& clay, const SweepResults& sweep)
{
  const formulas::PipeInClay pipe = clay.at(sweep.w);
  std::vector<Comparison> list;
  append_ends(list, "H in the middle", sweep.middle, safebuck_mid_sweep(pipe, sweep.V), "middle of a sweep");
  append_ends(list, against_a_berm, sweep.berm, safebuck_berm(pipe), "against the berm");
  return list;
}

std::vector<std::string> remarks_on(const ClayAround& clay)
{
  std::vector<std::string> remarks;
  if (std::isnan(clay.adhesion))
    remarks.emplace_back("The interface of this run has friction. Most formulas for clay have adhesion to the pipe only and are left out.");
  if (varies(clay.soil))
    remarks.emplace_back(
        "The strength of this run's clay varies with depth; formulas for uniform clay take its strength at the pipe's lowest point.");
  for (const material::Material& material : clay.soil.materials)
    if (const auto* law = material.get_if<material::Clay>(); law != nullptr && (law->sensitivity > 1 || law->rate_parameter > 0))
      remarks.push_back(fmt::format(
          "The strength of the clay of this run changes: sensitivity {:.3g}{}{}. The formulas take the intact strength s_u at the "
          "reference rate.",
          law->sensitivity,
          law->sensitivity > 1 ? fmt::format(", 95 % of the loss after a plastic shear strain of {:.3g}", law->ductility) : "",
          law->rate_parameter > 0
              ? fmt::format(", {:.2g} more for each tenfold rate above {:.2g} /s", law->rate_parameter, law->reference_rate)
              : ""));
  if (clay.unit_weight > 0)
    remarks.emplace_back("Vertical resistances include the weight of the clay that the pipe displaces, γ′ times F114's area.");
  return remarks;
}

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

std::vector<Comparison> sand_after_sweep(const SandAround& sand, const SweepResults& sweep)
{
  const Real w = std::isnan(sweep.residual) ? sweep.w : sweep.w_residual;
  return {{residual, Comparison::Unit::force, sweep.residual, f114_drained_lateral(sand.at(w), sweep.V),
           fmt::format("residual, as breakout at w = {:.3g} D", w / sand.diameter)}};
}

std::vector<std::string> remarks_on(const SandAround& sand)
{
  std::vector<std::string> remarks;
  if (!is_associated(sand))
    remarks.push_back(
        fmt::format("The method of characteristics is for associated soil, ψ = φ, which has more resistance. The sand of this run has φ = "
                    "{:.3g}° and dilates by ψ = {:.3g}°.",
                    sand.friction_angle / degree, sand.dilation_angle / degree));
  if (sand.cohesion > 0)
    remarks.push_back(fmt::format(
        "The formulas are for sand without cohesion. The sand of this run has c = {:.3g} Pa, which acts as a pressure c cot φ = {:.3g} Pa "
        "from all "
        "sides would, {:.2g} of γ' D: {}.",
        sand.cohesion, sand.cohesion / std::tan(sand.friction_angle),
        sand.cohesion / (std::tan(sand.friction_angle) * sand.unit_weight * sand.diameter),
        sand.has_little_cohesion()
            ? fmt::format("up to {:g} its effect is less than the differences between the formulas", base::little_cohesion)
            : fmt::format("beyond {:g} the formulas are out of range and too low, more so at small w", base::little_cohesion)));
  return remarks;
}

}  // namespace berm::pipe
