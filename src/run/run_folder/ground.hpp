// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"

namespace berm::run_folder {

/// The points along the free surface of finite elements from the left to the right wall, with those in contact with the body; none where it does not reach from wall to
/// wall, and in MPM.
std::vector<Index> ground_points(const SavedSoil& soil);

}  // namespace berm::run_folder
