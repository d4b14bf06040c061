// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/seabed.hpp"

namespace berm::mesh {

/// Throws KeyError where slope, trench and step are inconsistent with each other or with the lengths of the bed, which are right without them.
void check_ground(const SeabedMesh& bed);

/// The highest level of the surface from wall to wall: that at x = 0 of a line along the slope.
Real highest_surface_of(const SeabedMesh& bed);

/// Writes the geometry of a bed that is not level for the gmsh program. Throws RunError where it cannot write.
void write_uneven_geo(const SeabedMesh& bed, const std::filesystem::path& path);

}  // namespace berm::mesh
