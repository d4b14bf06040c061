// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Pipelines on slices that do not fit where their line goes.
inline const std::vector<SenselessInput>& senseless_pipelines()
{
  using enum SenselessInput::Answer;
  static const std::vector<SenselessInput> all = {
      {"pipeline_that_is_heated_fast",
       "line",
       warned,
       {"stage.heat.ramp", "on the springs of far_soil the line ends up", "with stages of the line 2", "times as long"},
       {"stage.heat.ramp=1 s", "stage.heat.until.time=2 s"},
       "",
       ""},
      {"pipeline_that_is_laid_heavier_than_its_line",
       "line",
       warned,
       {"stage.unload.force", "is 2500 N/m", "differs from the submerged weight of the line, 1500 N/m"},
       {"stage.unload.force=2.5 kN/m"},
       "",
       ""},
      {"slices_too_far_apart_for_the_lobe",
       "line",
       warned,
       {"pipeline.slices.spacing", "is 16 m, and a lobe of the line is", "7 are needed"},
       {"pipeline.slices.spacing=16 m", "pipeline.slices.to=80 m", "pipeline.imperfection.length=64 m"},
       "",
       ""},
      {"fine_cells_that_do_not_reach_the_crown",
       "line",
       warned,
       {"mesh.near_right", "the fine zone is too narrow", "at x = 0 m of the line"},
       {"mesh.near_right=1 m"},
       "",
       ""},
      {"fine_cells_that_do_not_reach_the_lobes_beside_the_crown",
       "line",
       warned,
       {"mesh.near_left", "expected lateral displacement -", "set it to -"},
       {"mesh.near_left=-0.2 m"},
       "",
       ""},
  };
  return all;
}

}  // namespace berm::test
