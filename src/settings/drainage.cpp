// SPDX-License-Identifier: BSD-3-Clause
#include "settings/drainage.hpp"

#include "bodies/initial_stress.hpp"
#include "settings/body_soil.hpp"

namespace berm::settings {
namespace {

SymTensor<3> stress_at_start(const Case& c, const bodies::BodySettings& body, Real depth)
{
  Real gravity = 0;
  for (const Real g : c.gravity) gravity = std::hypot(gravity, g);
  const SymTensor<2> plane = bodies::stress_at_rest<2>(body, gravity * soil_of(c, body).mass_above("", depth), depth);
  return {{plane[0], plane[1], plane[2]}};
}

}  // namespace

bool has_flowing_water(const Case& c, const std::string& name)
{
  return std::any_of(c.body.begin(), c.body.end(), [&](const auto& body) {
    return (name.empty() || body.first == name) && hydraulics(soil_of(c, body.second).materials.front()).has_value();
  });
}

std::optional<Real> strength_under(const material::Material& material, Real depth, Real pressure)
{
  if (!yields(material)) return {};
  const material::Material there = at_depth(material, depth);
  if (const std::optional<material::Strength> soil = strength_at_rest(there))
    return soil->cohesion * std::cos(soil->friction_angle) + pressure * std::sin(soil->friction_angle);
  const std::vector<Real> undisturbed(static_cast<std::size_t>(state_size(material)), 0);
  return shear_strength(there, -pressure, undisturbed.data());
}

std::optional<Real> part_of_real_time(const Case& c)
{
  constexpr Real same = 1e-6;
  std::optional<Real> part;
  for (const auto& entry : c.body)
    for (const material::Material& material : soil_of(c, entry.second).materials) {
      if (!hydraulics(material)) continue;
      const std::optional<material::PoreWater> water = pore_water(material);
      if (!water->real_permeability) return std::nullopt;
      const Real here = *water->real_permeability / *water->permeability;
      if (part && !(std::abs(here / *part - 1) < same)) return std::nullopt;
      part = here;
    }
  return part;
}

std::vector<Consolidation> consolidation_of(const Case& c, Real depth)
{
  std::vector<Consolidation> found;
  for (const auto& [name, body] : c.body) {
    const BodySoil soil = soil_of(c, body);
    const material::Material here = soil.at("", depth);
    const std::optional<material::Hydraulics> water = hydraulics(here);
    if (!water) continue;
    const SymTensor<3> stress = stress_at_start(c, body, depth);
    const Real modulus = oedometer_modulus(here, stress);
    found.push_back({soil.names[static_cast<std::size_t>(soil.material_index_at("", depth))], depth, modulus,
                     water->permeability / (material::unit_weight_of_water * (1 / modulus + 1 / water_stiffness(here))),
                     inertia_density(here), strength_under(here, 0, -stress[1]).value_or(0)});
  }
  return found;
}

std::vector<StageDrainage> drainage_of_stages(const Case& c, Real width, Real c_v)
{
  std::vector<StageDrainage> found;
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const StageSettings& stage = c.stage[k];
    if (stage.kind == StageKind::geostatic || stage.kind == StageKind::sweep || has_load_history(stage)) continue;
    const Real speed = speed_of(stage);
    found.push_back({k, speed > 0, speed > 0 ? speed * width / c_v : stage.until.time ? c_v * *stage.until.time / (width * width) : nan});
  }
  return found;
}

std::optional<StageInertia> inertia_in(const Case& c, const StageDrainage& stage, const Consolidation& soil, Real width)
{
  constexpr Real T50 = 0.1;  // of a pipe: examples/pipe_consolidation
  if (c.method != Method::mpm) return {};
  if (!stage.moves) return StageInertia{StageInertia::Measure::rest, soil.c_v / (T50 * width * soil.wave())};
  const Real speed = speed_of(c.stage[stage.stage]);
  if (soil.strength > 0) return StageInertia{StageInertia::Measure::strength, soil.density * speed * speed / soil.strength};
  return StageInertia{StageInertia::Measure::wave, speed / soil.wave()};
}

}  // namespace berm::settings
