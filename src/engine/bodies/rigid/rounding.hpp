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

/// The arc that takes the place of a re-entrant corner: its centre lies outside of the body, and its ends are where the sides have these normals.
struct Fillet {
  Vec<2> center;
  Vec<2> before, behind;  ///< unit vectors out of the body
  Real radius;            ///< m
};

/// Arcs of this radius (m) for the re-entrant corners of a profile, as far as its sides leave room for them; none for other shapes.
std::vector<Fillet> fillets_of(const RigidShape<2>& shape, Real radius);

/// The surface at a point that has this one without the fillets.
SurfacePoint<2> with_fillets(const std::vector<Fillet>& fillets, const SurfacePoint<2>& sharp, const Vec<2>& x);

}  // namespace berm::bodies
