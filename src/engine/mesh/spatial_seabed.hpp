// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/seabed.hpp"

namespace berm::mesh {

/// The bed in space: bricks between planes along x, y and z, each cut into Kuhn's six tetrahedra. Bricks are cubes of about near_size in the fine zone; along
/// each axis by itself they grow outwards from it as in the plane. Upright lines are moved so that they meet the surface of a slope, a trench or a step, which
/// are the same along z: the fine zone goes with the surface, and what is left up to the base and its layer, and up to the top, is stretched or compressed.
///
/// Regions and boundaries are those of the plane, and boundaries "back" (z smallest) and "front"; the layer lies along them, too, but where the fine zone begins
/// at a wall. Throws KeyError where lengths are inconsistent.
Mesh<3> make_spatial_seabed(const SeabedMesh& seabed);

/// Number of its tetrahedra.
Real cells_in_space(const SeabedMesh& seabed);

/// Throws KeyError where the lengths along z are inconsistent, or the surface bends too much for the mesh in space; a plane bed passes that has none of them.
void check_across(const SeabedMesh& seabed);

/// Throws KeyError where a bed is plane and the case in space, or the other way around.
void refuse_other_dimension(const SeabedMesh& seabed, int dim);

}  // namespace berm::mesh
