// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Mesh files that are asked for in a way that makes no sense; the file itself is not there.
inline const std::vector<SenselessInput>& senseless_meshes()
{
  using enum SenselessInput::Answer;
  constexpr const char* box = "kind = \"box\"\nsize = [\"120 mm\", \"60 mm\"]\ncells = [30, 15]";
  static const std::string file = "kind = \"gmsh\"\nfile = \"none.msh\"\n";
  static const std::vector<SenselessInput> all = {
      {"axis_that_is_none", "box", refused, {"mesh.axes", "\"w\" is not an axis"}, {}, box, file + "axes = [\"x\", \"w\"]"},
      {"axis_without_name", "box", refused, {"mesh.axes", "must not be empty"}, {}, box, file + "axes = [\"x\", \"\"]"},
      {"axis_twice", "box", refused, {"mesh.axes", "takes z of the file twice"}, {}, box, file + "axes = [\"z\", \"-z\"]"},
      {"one_axis", "box", refused, {"mesh.axes", "needs 2 axes, and has 1"}, {}, box, file + "axes = [\"x\"]"},
      {"shift_in_space", "box", refused, {"mesh.shift", "2"}, {}, box, file + "shift = [1, 2, 3]"},
      {"scale_of_nothing", "box", refused, {"mesh.scale"}, {}, box, file + "scale = 0"},
      {"tolerance_below_nothing", "box", refused, {"mesh.merge_tolerance"}, {}, box, file + "merge_tolerance = \"-1 mm\""},
      {"scale_of_a_box", "box", refused, {"mesh.scale", "applies with kind"}, {"mesh.scale=0.001"}, "", ""},
      {"origin_out_of_reach_of_the_numbers",
       "box",
       refused,
       {"mesh", "1e+09 m from the origin", "2.2e-07 m apart", "move the origin"},
       {"mesh.lower=[1e9, 0]", "body.sand.block.center=[1000000000.06, 0.02]", "rigid.pipe.center=[1000000000.05, 0.05]"},
       "",
       ""},
      {"slices_thinner_than_cells",
       "settling",
       warned,
       {"rigid.pile.depth_slices", "take 50 or fewer"},
       {"rigid.pile.depth_slices=100"},
       "",
       ""},
      {"soil_that_jolts_along_slices", "settling", warned, {"rigid.pile.depth_slices", "cut_cells"}, {"mpm.quadrature=full_cells"}, "", ""},
      {"ring_closed_by_its_first_corner",
       "box",
       refused,
       {"rigid.pipe.x", "leave the last corner out"},
       {},
       "shape = \"circle\"\ncenter = [\"50 mm\", \"50 mm\"]\ndiameter = \"20 mm\"",
       "shape = \"polygon\"\nx = [0.04, 0.06, 0.06, 0.04, 0.04]\ny = [0.04, 0.04, 0.06, 0.06, 0.04]"},
  };
  return all;
}

}  // namespace berm::test
