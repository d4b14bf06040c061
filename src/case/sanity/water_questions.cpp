// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "core/names.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {

void is_the_soil_as_heavy_as_in_water(const Scene& s, Findings& found)
{
  constexpr Real sea_water = 1025, heaviest_in_water = 1300, heaviest_dry = 1900, heaviest_saturated = 3000, lightest = 300;  // kg/m3
  if (s.gravity == 0) return;
  const bool seabed = std::holds_alternative<mesh::SeabedMesh>(s.c.mesh);
  for (const auto& [name, body] : s.c.body) {
    const settings::BodySoil soil = soil_of(s.c, body);
    for (std::size_t k = 0; k < soil.materials.size(); ++k) {
      const material::Material& asked = s.c.material[index_of(s.c.material, soil.names[k])].second;
      const Real own = density(asked);
      const std::string path = "material." + soil.names[k] + ".", weight = path + "submerged_unit_weight";
      const bool as_weight = s.places.has(weight);
      if (!yields(asked)) continue;
      if (own >= 100 && own < lightest)
        found.warn(
            as_weight ? weight : path + "density",
            fmt::format(
                "is {:.3g} kg/m3, {:.2g} kN/m3: the effective unit weight of very soft clay is 3 kN/m3, of sand 8 to 11: is the unit "
                "right? submerged_unit_weight takes it in kN/m^3",
                own, own * standard_gravity / 1e3));
      if (own < heaviest_in_water || own > 4000) continue;
      const std::optional<material::Strength> strength = strength_at_rest(asked);
      const bool is_clay = strength && strength->friction_angle == 0;  // no undrained strength without water
      const std::string why = as_weight                  ? "the effective unit weight of soil is 3 to 12 kN/m3, the saturated one 14 to 22"
                              : has_pore_pressure(asked) ? "the pore pressure carries the weight of its water, and density gives the rest"
                              : inertia_density(asked) != own && inertia_density(asked) < heaviest_saturated
                                  ? "inertia_density is the saturated density, so density has to give the effective unit weight"
                              : seabed && (own >= heaviest_dry || is_clay)
                                  ? "it is that of soil with water in its pores, and a seabed lies in water"
                                  : "";
      if (why.empty()) continue;
      found.warn(
          as_weight ? weight : path + "density",
          fmt::format("is {:.4g} kg/m3: {}; if it is submerged write submerged_unit_weight = \"{:.2g} kN/m^3\", that of this density less "
                      "water",
                      own, why, (own - sea_water) * standard_gravity / 1e3));
    }
  }
}

namespace {

/// Whether a support lies below the soil of a body, over all of its base: level at its lowest edge.
bool is_base_of(const Scene& s, std::size_t support, const BodyScene& body)
{
  constexpr Real flat = 1e-6;
  const Span &level = s.supports[support].space[s.up], &soil = body.space[s.up];
  const Real base = s.up_sign > 0 ? soil.from : soil.to;
  return std::abs(level.from - base) < flat * soil.length() && std::abs(level.to - base) < flat * soil.length();
}

/// A bed through which water flows up steadily: where it is nearest to having no weight, the deepest of such places.
struct Uplift {
  Real part = 0;      ///< excess pore pressure over the effective stress that there is without it, at most
  Real depth = 0;     ///< m, there
  Real gradient = 0;  ///< mean hydraulic gradient above
  Real critical = 0;  ///< gamma' / gamma_w above
};

Uplift uplift_of(const Scene& s, Index body, Real pressure)
{
  constexpr int slices = 200;
  const settings::BodySoil soil = soil_of(s.c, s.c.body[body].second);
  const Real height = s.depth_of(body), thick = height / slices;
  std::vector<Real> resistance = {0};  // of the soil above, m/(m/s)
  for (int k = 0; k < slices; ++k) {
    const std::optional<material::Hydraulics> water = hydraulics(soil.at("", (k + 0.5) * thick));
    resistance.push_back(resistance.back() + (water ? thick / water->permeability : 0));
  }
  Uplift worst;
  for (int k = 1; k <= slices; ++k) {
    const Real depth = k * thick, excess = pressure * resistance[k] / resistance.back(), weight = s.weight_above(body, depth);
    if (const Real part = excess / weight; part >= worst.part * (1 - 1e-9))
      worst = {part, depth, excess / material::unit_weight_of_water / depth, weight / material::unit_weight_of_water / depth};
  }
  return worst;
}

}  // namespace

void does_the_soil_keep_its_weight(const Scene& s, Findings& found)
{
  constexpr Real near = 0.9;
  if (s.gravity == 0 || !s.ground.line.level()) return;
  for (std::size_t k = 0; k < s.c.support.size(); ++k) {
    const auto& [name, support] = s.c.support[k];
    if (!support.head || !(*support.head > 0)) continue;
    for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
      if (!is_base_of(s, k, s.bodies[b]) || !(s.depth_of(b) > 0) || !settings::has_flowing_water(s.c, s.c.body[b].first)) continue;
      const Uplift uplift = uplift_of(s, b, material::unit_weight_of_water * *support.head);
      if (uplift.part < near) continue;
      found.warn("support." + name + ".head",
                 fmt::format("drives water up through [body.{}] at a gradient of {:.3g} above {}, where the soil {} its weight: i_c = "
                             "gamma'/gamma_w = {:.3g} there; a head of {} leaves a tenth of it",
                             s.c.body[b].first, uplift.gradient, words_of(uplift.depth, "m"), uplift.part > 1 ? "loses" : "nearly loses",
                             uplift.critical, words_of(near * *support.head / uplift.part, "m")));
    }
  }
}

void is_the_head_there_when_soil_rests(const Scene& s, Findings& found)
{
  for (const auto& [name, support] : s.c.support) {
    if (!support.head || *support.head == 0) continue;
    for (const settings::StageSettings& stage : s.c.stage) {
      const bool acts = acts_in(support.stages, stage.name);
      if (!acts || stage.kind != settings::StageKind::geostatic) continue;
      found.warn("support." + name + ".head",
                 fmt::format("acts in the geostatic stage \"{}\", which ends when forces are in balance, not when the flow of water is "
                             "steady: name the stages after it in `stages`, and hold the boundary in \"{}\" by a support without a head",
                             stage.name, stage.name));
      break;
    }
  }
}

void does_water_have_time_to_flow(const Scene& s, Findings& found)
{
  constexpr Real nothing_drains = 0.01, drained = 10;
  const Index rigid = main_rigid(s.c);
  const Real width = rigid == none ? 0 : s.rigids[rigid].width;
  if (!(width > 0)) return;
  const std::vector<settings::Consolidation> soils = consolidation_of(s.c, width);
  if (soils.empty()) return;
  const settings::Consolidation& soil = soils.front();
  const material::Material& material = s.c.material[index_of(s.c.material, soil.material)].second;
  const Real wave = soil.wave(), all = width * width / soil.c_v;
  for (const settings::StageDrainage& stage : drainage_of_stages(s.c, width, soil.c_v)) {
    const settings::StageKind kind = s.c.stage[stage.stage].kind;
    if (kind != settings::StageKind::drive && kind != settings::StageKind::free) continue;  // what a force loads does not rest
    if (stage.moves) continue;
    if (stage.number < nothing_drains)
      found.warn(
          stage_key(stage.stage, "until.time"),
          fmt::format("is T = c_v t/D2 = {:.2g}: almost nothing drains; half of the pressure has dissipated at about T = 0.1, {}, all of "
                      "it at T = 10: take more time or, since time may be scaled, a larger permeability and a larger velocity",
                      stage.number, words_of(all / 10, "s")));
    else if (const std::optional<settings::StageInertia> inertia = inertia_in(s.c, stage, soil, width);
             inertia && inertia->is_large() && !(stage.number > drained))
      found.warn(
          "material." + soil.material + ".water.permeability",
          fmt::format(
              "gives c_v = {:.3g} m2/s: in stage \"{}\" half of the pressure below the body dissipates within {}, and waves, which take {} "
              "across it, affect how; up to {} the soil consolidates as in reality",
              soil.c_v, s.c.stage[stage.stage].name, words_of(all / 10, "s"), words_of(width / wave, "s"),
              words_of(rounded_down(hydraulics(material)->permeability * settings::StageInertia::largest_at_rest / inertia->part), "m/s")));
  }
}

}  // namespace berm::sanity
