// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Those in space and around an axis.
inline const std::vector<SenselessInput>& senseless_inputs_in_space()
{
  using enum SenselessInput::Answer;
  static const std::vector<SenselessInput> all = {
      {"wall_across_the_path", "space", warned, {"mesh.width", "the front wall is", "or more"}, {}, "", ""},
      {"wall_beside_a_plane_of_symmetry",
       "space",
       warned,
       {"mesh.length", "the right wall is", "or more"},
       {"rigid.pipe.length=0.45 m"},
       "",
       ""},
      {"wall_that_cuts_a_body",
       "space",
       warned,
       {"rigid.pipe", "the front wall cuts it: it reaches z = 0.23 m", "plane of symmetry"},
       {"rigid.pipe.center=[0, \"80 mm\", \"0.15 m\"]"},
       "",
       ""},
      {"path_out_of_the_mesh_in_space",
       "space",
       refused,
       {"stage.drag.until", "reaches z = 0.38 m", "where the mesh ends at 0.2 m"},
       {"stage.drag.until.displacement=0.3 m"},
       "",
       ""},
      {"fine_zone_that_ends_before_the_body",
       "space",
       warned,
       {"mesh.near_front", "\"pipe\" reaches 0.1 m", "make the fine zone reach beyond it"},
       {"mesh.near_front=0.04", "rigid.pipe.axis=[0, 0, 1]"},
       "",
       ""},
      {"wall_around_the_axis_at_the_body",
       "cone",
       warned,
       {"mesh.length", "the wall is 22", "carries part of the force"},
       {"mesh.length=40 mm"},
       "",
       ""},
      {"wall_in_the_plastic_zone_of_a_cone",
       "cone",
       warned,
       {"mesh.length", "has a radius of 0.179 m", "G/s_u = 100", "make the mesh 0.4 m long"},
       {"mesh.length=0.1 m"},
       "",
       ""},
  };
  return all;
}

}  // namespace berm::test
