// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Remeshed runs that make no sense: a pipe that is laid and dragged, and one beside another ("pipes").
inline const std::vector<SenselessInput>& senseless_remeshed()
{
  using enum SenselessInput::Answer;
  static const std::vector<SenselessInput> all = {
      {"remeshed_begins_above_the_bed",
       "remeshed",
       warned,
       {"rigid.pipe", "begins 0.2 m above the seabed"},
       {"rigid.pipe.center=[0, \"0.7 m\"]"},
       "",
       ""},
      {"remeshed_begins_in_a_cavity",
       "remeshed",
       warned,
       {"rigid.pipe.center", "puts the lowest point 0.13 m", "in a cavity without soil"},
       {"rigid.pipe.center=[0, \"0.37 m\"]"},
       "",
       ""},
      {"remeshed_drag_without_travel",
       "remeshed",
       warned,
       {"stage.drag.until.displacement", "is the unit right?"},
       {"stage.drag.until.displacement=\"3 mm\""},
       "",
       ""},
      {"remeshed_force_that_the_soil_may_carry",
       "remeshed",
       warned,
       {"stage.unload.until", "may never be reached", "add until.time"},
       {"stage.unload.until={embedment=\"0.5 m\"}"},
       "until.time = \"0.3 s\"",
       ""},
      {"remeshed_leaves_the_mesh",
       "remeshed",
       refused,
       {"stage.drag.until", "out of the mesh"},
       {"stage.drag.until.displacement=\"30 m\""},
       "",
       ""},
      {"remeshed_near_the_wall", "remeshed", warned, {"mesh.length", "wall is"}, {"mesh.left=\"1 m\""}, "", ""},
      {"remeshed_near_the_base",
       "remeshed",
       warned,
       {"mesh.depth", "base is"},
       {"mesh.depth=\"0.9 m\"", "mesh.near_depth=\"0.6 m\""},
       "",
       ""},
      {"remeshed_cut_by_a_wall",
       "remeshed",
       warned,
       {"rigid.pipe", "the left wall cuts it"},
       {"mesh.left=\"0.3 m\"", "mesh.near_left=\"-0.3 m\""},
       "",
       ""},
      {"remeshed_meets_another_body",
       "pipes",
       warned,
       {"stage.lay.rigid", "\"new\" may meet \"old\"", "a quarter of an element apart"},
       {"rigid.old.center=[\"0.9 m\", 0]"},
       "",
       ""},
  };
  return all;
}

}  // namespace berm::test
