// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape.hpp"

namespace berm::bodies {

/// The polygon whose sides lie deeper by the radius (m), of corners counter-clockwise; a negative radius goes back.
std::vector<Vec<2>> core_of(const std::vector<Vec<2>>& corners, Real radius);

/// Whether the arcs of the corners leave something of each side.
bool leaves_sides(const std::vector<Vec<2>>& corners, const std::vector<Vec<2>>& core);

/// A box, polygon or profile with arcs of this radius (m) at its convex corners, as far as its sides leave room for them. Arcs that are larger stay, and so do other shapes.
RigidShape<2> rounded(const RigidShape<2>& shape, Real radius);

}  // namespace berm::bodies
