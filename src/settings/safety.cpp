// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/safety_test.cpp
#include "settings/safety.hpp"

#include "settings/body_soil.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::settings {
namespace {

void weaken(Real& friction_angle, Real& adhesion, Real factor)
{
  friction_angle = std::atan(std::tan(friction_angle) / factor);
  adhesion /= factor;
}

bool has_load(const Case& c)
{
  const auto pushes = [](const StageSettings& stage) {
    const FreedomSettings* freedoms[] = {&stage.drive.x, &stage.drive.y, &stage.drive.z};
    return stage.force || stage.vertical_force || has_load_history(stage) ||
           std::any_of(std::begin(freedoms), std::end(freedoms), [](const FreedomSettings* f) { return f->force.has_value(); });
  };
  return std::any_of(c.gravity.begin(), c.gravity.end(), [](Real g) { return g != 0; }) || !c.traction.empty() ||
         std::any_of(c.stage.begin(), c.stage.end(), pushes);
}

}  // namespace

Case with_reduced_strength(Case c)
{
  if (!c.safety) return c;
  const Real factor = c.safety->factor;
  for (auto& [name, soil] : c.material)
    if (const std::optional<material::Material> weaker = with_strength_over(soil, factor)) soil = *weaker;
  for (auto& [name, field] : c.random_field)
    for (SoundingSettings& sounding : field.sounding)
      for (Real& value : sounding.value)
        if (field.property != stiffness_word) value /= factor;
  for (auto& [name, contact] : c.contact) {
    weaken(contact.friction_angle, contact.adhesion, factor);
    contact.tension /= factor;
    for (contact::SoilInterfaceSettings& beside : contact.soil) weaken(beside.friction_angle, beside.adhesion, factor);
  }
  for (StageSettings& stage : c.stage) stage.equilibrium = std::min(stage.equilibrium, strictest_equilibrium);
  return c;
}

bool moves_body(const StageSettings& stage)
{
  if (!drives(stage.kind)) return false;
  const TurnSettings* turns[] = {&stage.drive.rotation, &stage.drive.rotation_x, &stage.drive.rotation_y, &stage.drive.rotation_z};
  const bool turned =
      std::any_of(std::begin(turns), std::end(turns), [](const TurnSettings* turn) { return turn->velocity.value_or(0) != 0; });
  return stage.kind == StageKind::sweep || turned || speed_of(stage) > 0;
}

void check_safety(Describe& d, const Case& c)
{
  if (!c.safety) return;
  bool yields_somewhere = false;
  for (const auto& [name, soil] : c.material) {
    if (!is_used(c, name)) continue;
    yields_somewhere = yields_somewhere || yields(soil);
    d.check(
        with_strength_over(soil, c.safety->factor).has_value(), "material." + name + ".law",
        fmt::format(
            "\"{}\" has no strength that a factor of safety divides: that of a critical-state soil and of hypoplastic sand follows from "
            "its density and pressure, and the meaning of the properties of a user law is not known; take \"mohr_coulomb\", \"clay\", "
            "\"hardening_soil\" or \"ngi_adp\"",
            material::law_word(soil)));
  }
  d.check(yields_somewhere, "material",
          "no soil of this case has a strength that a factor of safety could divide: give one the law mohr_coulomb or clay");
  for (const auto& [name, body] : c.body)
    d.check(body.fill.empty() && body.excavation.empty(), "body." + name,
            "a trial of the factor of safety follows the movement of soil that is there from the start to the end: leave out its fills and "
            "excavations, and let the case begin with the ground as it is then");
  d.check(has_load(c), "gravity", "nothing loads the soil of this case, so it never fails: add gravity, a traction or a force");
  d.check(c.stage.empty() || !moves_body(c.stage.back()), fmt::format("stage[{}].kind", c.stage.empty() ? 0 : c.stage.size() - 1),
          "the last stage moves a body, so that the soil cannot come to rest: add a stage after it that is geostatic, free, or driven by a "
          "force");
}

Real time_factor_of_last_stage(const Case& c, Real depth)
{
  const std::optional<Real> time = c.stage.empty() ? std::nullopt : c.stage.back().until.time;
  if (!time) return nan;
  Real factor = nan;
  for (const Consolidation& soil : consolidation_of(c, depth / 2)) factor = std::fmin(factor, soil.c_v * *time / (depth * depth));
  return factor;
}

}  // namespace berm::settings
