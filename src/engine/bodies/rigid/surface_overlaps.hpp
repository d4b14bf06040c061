// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/triangle_mesh.hpp"

#include <string>

namespace berm::bodies {

/// What is wrong with closed surfaces of a size (m) that should bound a body together, "" where nothing is: triangles that cut through each other or lie on each other, and
/// volume that is counted twice or less than once. `surface_of`: of each triangle, one that stands for its surface. Throws Interrupted where a signal asks to stop.
std::string overlaps_of(const Triangles& triangles, const std::vector<Index>& surface_of, Real size);

}  // namespace berm::bodies
