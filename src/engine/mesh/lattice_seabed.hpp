// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/seabed.hpp"

namespace berm::mesh {

/// The level or sloping bed in the plane as a lattice: rows of triangles, equilateral with sides of near_size in the fine zone, wider and higher outwards from it. The
/// surface is a line of sides. Under x = 0 a side of the surface has its middle, or there is the left wall where the fine zone begins at it, and the lattice right of it is the mirror image of that left of
/// it as far as both reach. The fine zone extends to whole triangles, but to no row that would leave a thin one at the base or the top. A slope shears the lattice.
///
///     surface  ---o-------o---x=0---o-------o---
///                / \     / \  |    / \     / \         errors of cells are the same for a body that moves to the
///               /   \   /   \ |   /   \   /   \        left and to the right, and change smoothly with near_size
///              o-----o-------o-------o-----o
///
/// Regions and boundaries are called as in the mesh of Gmsh; the edges of regions go along the triangles. Each triangle names its patch. Throws KeyError where lengths are inconsistent.
Mesh<2> make_lattice_seabed(const SeabedMesh& seabed);

/// Number of its triangles.
Real cells_in_lattice(const SeabedMesh& seabed);

}  // namespace berm::mesh
