// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"
#include "sanity/words.hpp"

#include <fmt/format.h>

namespace berm::sanity {

using problem::StageKind;
using problem::StageSettings;

void does_water_flow_while_bodies_rest(const Scene& s, Findings& found)
{
  constexpr Real hardly = 0.01;  // T: less than a tenth of the pressure at a pipe is gone
  std::size_t longest = s.c.stage.size();
  Real most = 0;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    const Index rigid = s.ways[k].rigid, body = rigid == none ? none : s.touched_by(rigid);
    if (body == none || speed_of(stage) > 0 || stage.kind == StageKind::sweep || !stage.load_times.empty()) continue;
    if (stage.until.consolidation || !stage.until.time) return;
    const Real D = s.rigids[rigid].width, T = D > 0 ? consolidation_coefficient(s.material_of(body)) * *stage.until.time / (D * D) : 0;
    if (T > most) longest = k, most = T;
  }
  if (most == 0 || most > hardly) return;
  found.warn(stage_key(longest, "until.time"),
             fmt::format("is {}, in which hardly any water flows: T = c_v t / D^2 = {:.2g}; take {} or more, or a larger permeability",
                         words_of(*s.c.stage[longest].until.time, "s"), most,
                         words_of(rounded_up(*s.c.stage[longest].until.time * 0.1 / most), "s")));
}

void does_drag_rather_than_inertia_hold_the_water(const Scene& s, Findings& found)
{
  constexpr Real doubtful = 0.5;  // c_v / (c D)
  if (!s.is_mpm()) return;
  for (Index rigid = 0; rigid < static_cast<Index>(s.rigids.size()); ++rigid) {
    const Index body = s.touched_by(rigid);
    if (body == none || !(s.rigids[rigid].width > 0)) continue;
    const material::Material& soil = s.material_of(body);
    const Real wave = std::sqrt(p_wave_modulus(elasticity(soil)) / inertia_density(soil));
    const Real part = consolidation_coefficient(soil) / (wave * s.rigids[rigid].width);
    if (part <= doubtful) continue;
    found.warn("material." + s.c.body[body].second.material + ".water.permeability",
               fmt::format("is {}: so large that water flows over D as fast as waves of the skeleton run ({:.3g} m/s), and the inertia of "
                           "both decides; take "
                           "{} or less and drive as much slower, or water.drainage = \"drained\"",
                           words_of(hydraulics(soil)->permeability, "m/s"), wave,
                           words_of(rounded_down(hydraulics(soil)->permeability * 0.1 / part), "m/s")));
    return;
  }
}

}  // namespace berm::sanity
