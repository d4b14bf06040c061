// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/simulate.hpp"

namespace berm::simulation {

/// An unfinished run, resumed on a longer mesh: `set` has KEY=VALUE of mesh.near_left, near_right, left and length. Where they leave the mesh as it is, the run is resumed as it is. Throws InputError
/// for another key, a mesh that does not hold the one before, and cases of another method or geometry.
RunRequest on_longer_mesh(const RunRequest& resumed, const std::vector<std::string>& set);

}  // namespace berm::simulation
