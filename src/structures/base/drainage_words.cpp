// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/drainage_words.hpp"

#include "structures/base/driven_body.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::base {
namespace {

constexpr Real drained_below = 0.01, undrained_above = 100;

}  // namespace

std::string drainage_in_words(const problem::Case& c, const problem::StageSettings& stage)
{
  const std::optional<material::Material> soil = touched_material(c);
  const Real c_v = soil ? consolidation_coefficient(*soil) : 0, D = body_scale(c).width;
  if (!(c_v > 0) || !(D > 0)) return "";
  if (const Real speed = speed_of(stage); speed > 0) {
    const Real rate = speed * D / c_v;
    return fmt::format("v D/c_v = {:.3g}: {}", rate,
                       rate < drained_below     ? "drained"
                       : rate > undrained_above ? "undrained"
                                                : "partly drained");
  }
  if (!stage.until.time || stage.kind == problem::StageKind::geostatic) return "";
  return fmt::format("T = c_v t/D² = {:.3g}", c_v * *stage.until.time / (D * D));
}

std::vector<std::string> drainage_words(const problem::Case& c)
{
  std::vector<std::string> lines;
  for (const auto& [name, material] : c.material) {
    const std::optional<material::Hydraulics> water = hydraulics(material);
    if (!water) continue;
    lines.push_back(fmt::format("{}\"{}\": c_v = {:.3g} m²/s: k = {:.3g} m/s, M = {}, K_w/n = {}",
                                lines.empty() ? "water        " : "             ", name, consolidation_coefficient(material),
                                water->permeability, text::stress_words(p_wave_modulus(elasticity(material))),
                                text::stress_words(water_stiffness(material))));
  }
  if (lines.empty()) return lines;
  for (const problem::StageSettings& stage : c.stage)
    if (const std::string words = drainage_in_words(c, stage); !words.empty())
      lines.push_back(fmt::format("             {}: {}", stage.name, words));
  return lines;
}

}  // namespace berm::base
