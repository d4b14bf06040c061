// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Supports that move, and water outside of them, that make no sense.
inline const std::vector<SenselessInput>& senseless_supports()
{
  using enum SenselessInput::Answer;
  const std::string base = "[support.base]\nboundary = \"bottom\"\nfixed = [\"x\", \"y\"]\n";
  const auto moves = [&](const std::string& rows) { return base + "[support.base.motion]\nstages = [\"drag\"]\n" + rows; };
  static const std::vector<SenselessInput> all = {
      {"motion_too_fast_for_the_cells",
       "box",
       warned,
       {"support.base.motion", "moves along x from one peak to the next in 0.002 ms", "8 cells to a shear wave", "filter the record"},
       {},
       base,
       moves("times = [0, 1e-6, 2e-6]\nx = [0, 0.01, 0]\n")},
      {"motion_that_begins_with_a_jump",
       "box",
       warned,
       {"support.base.motion", "starts with a velocity jump along x"},
       {},
       base,
       moves("times = [0, 1e-2]\nx = [1e-3, 0]\n")},
      {"motion_that_does_not_end",
       "box",
       warned,
       {"support.base.motion", "ends at 1 mm/s along x", "make the last velocity 0"},
       {},
       base,
       moves("times = [0, 1e-3]\nx = [0, 1e-3]\n")},
      {"motion_that_takes_the_soil_off_its_nodes",
       "box",
       refused,
       {"support.base.motion", "moves the soil along y by 10 mm to either side, 2.5 of a cell", "the soil leaves the nodes that move it"},
       {},
       base,
       moves("times = [0, 1e-3, 2e-3]\ny = [0, 10, 0]\n")},
      {"motion_that_adds_up_over_stages",
       "box",
       refused,
       {"support.base.motion", "moves the soil along y by 3 mm to either side, 0.75 of a cell"},
       {},
       base,
       base + "[support.base.motion]\nstages = [\"push\", \"drag\"]\ntimes = [0, 1e-3, 2e-3]\ny = [0, 1.5, 0]\n"},
      {"motion_that_its_stage_cuts",
       "box",
       warned,
       {"support.base.motion", "along x where stage \"push\" ends, and the boundary stops abruptly"},
       {},
       base,
       base + "[support.base.motion]\nstages = [\"push\"]\ntimes = [0, 1e3, 2e3]\nx = [0, 1e-9, 0]\n"},
      {"motion_that_takes_the_soil_out_of_the_mesh",
       "box",
       refused,
       {"support.base.motion", "moves the soil along x by 1 mm to either side, 0.25 of a cell", "ends along x where the soil does"},
       {},
       base,
       moves("times = [0, 1e-3, 2e-3]\nx = [0, 1, 0]\n")},
      {"load_that_stays_on_a_base_that_absorbs",
       "bed",
       warned,
       {"support.base.absorbs", "absorbs along y, and fill \"berm\" comes after the soil has come to rest", "the soil settles at"},
       {"support.base.absorbs=true",
        "body.sand.fill=[{name=\"berm\", material=\"sand\", stage=\"drag\", x=[0.1, 0.12, 0.11], y=[0, 0, 0.01]}]"},
       "",
       ""},
      {"head_that_takes_the_weight",
       "bed",
       warned,
       {"support.base.head", "drives water up through [body.sand] at a gradient of 50 above 0.14 m, where the soil loses its weight",
        "i_c = gamma'/gamma_w = 43.8"},
       {"material.sand.inertia_density=1877", "material.sand.water.drainage=consolidation", "material.sand.water.permeability=1e-3",
        "material.sand.water.porosity=0.4", "support.base.drained=true", "support.base.head=7 m"},
       "",
       ""},
      {"head_while_the_soil_comes_to_rest",
       "bed",
       warned,
       {"support.base.head", "acts in the geostatic stage \"geostatic\"", "name the stages after it"},
       {"material.sand.inertia_density=1877", "material.sand.water.drainage=consolidation", "material.sand.water.permeability=1e-3",
        "material.sand.water.porosity=0.4", "support.base.drained=true", "support.base.head=1 m"},
       "",
       ""},
  };
  return all;
}

}  // namespace berm::test
