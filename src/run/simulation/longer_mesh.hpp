// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/simulate.hpp"

namespace berm::simulation {

/// An unfinished run, resumed on a longer mesh: `set` has KEY=VALUE of mesh.near_left, near_right, left and length. Where they leave the mesh as it is, the run is resumed as it is. Throws InputError
/// for another key, a mesh that does not hold the one before, and cases of another method, geometry or pattern.
RunRequest on_longer_mesh(const RunRequest& resumed, const std::vector<std::string>& set);

/// Along x, m.
struct Extent {
  Real from, to;
};
/// Of what a run drives.
struct Sides {
  Extent start, now;
};

/// The command that resumes a run on a mesh whose fine zone reaches three widths further than what it drives, where that has come nearer to the end of the fine zone than its width, so that the soil ahead of it
/// deforms in coarse cells; "" where it has not, and for cases that are not resumed on a longer mesh.
std::string command_to_lengthen(const RunRequest& run, const Sides& sides);

}  // namespace berm::simulation
