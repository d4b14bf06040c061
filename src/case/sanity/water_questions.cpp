// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "problem/drainage.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <fmt/format.h>

namespace berm::sanity {

void does_water_have_time_to_flow(const Scene& s, Findings& found)
{
  constexpr Real nothing_drains = 0.01, drained = 10;
  const Index rigid = main_rigid(s.c);
  const Real width = rigid == none ? 0 : s.rigids[rigid].width;
  if (!(width > 0)) return;
  const std::vector<problem::Consolidation> soils = consolidation_of(s.c, width);
  if (soils.empty()) return;
  const problem::Consolidation& soil = soils.front();
  const material::Material& material = s.c.material[problem::index_of(s.c.material, soil.material)].second;
  const Real wave = soil.wave(), all = width * width / soil.c_v;
  for (const problem::StageDrainage& stage : drainage_of_stages(s.c, width, soil.c_v)) {
    const problem::StageKind kind = s.c.stage[stage.stage].kind;
    if (kind != problem::StageKind::drive && kind != problem::StageKind::free) continue;  // what a force loads does not rest
    if (stage.moves) continue;
    if (stage.number < nothing_drains)
      found.warn(
          stage_key(stage.stage, "until.time"),
          fmt::format("is T = c_v t/D2 = {:.2g}: next to nothing drains; half of the pressure takes T = 0.1 or so, {}, all of it T = "
                      "10: take more time or, as time may be scaled, a larger permeability and a larger velocity",
                      stage.number, words_of(all / 10, "s")));
    else if (const std::optional<problem::StageInertia> inertia = inertia_in(s.c, stage, soil, width);
             inertia && inertia->is_large() && !(stage.number > drained))
      found.warn(
          "material." + soil.material + ".water.permeability",
          fmt::format(
              "gives c_v = {:.3g} m2/s: in stage \"{}\" half of the pressure below the body goes within {}, and waves, which take "
              "{} across it, decide how; up to {} the soil consolidates as it does in nature",
              soil.c_v, s.c.stage[stage.stage].name, words_of(all / 10, "s"), words_of(width / wave, "s"),
              words_of(rounded_down(hydraulics(material)->permeability * problem::StageInertia::largest_at_rest / inertia->part), "m/s")));
  }
}

}  // namespace berm::sanity
