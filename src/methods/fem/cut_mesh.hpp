// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape.hpp"
#include "settings/case.hpp"

#include <filesystem>

namespace berm::fem {

/// The mesh of the soil around the rigid bodies in contact with it, for the method "fem".
///
/// A mesh of kind "seabed" holds the soil alone, y <= 0, without the rigid bodies: regions "near", "bed", "layer" and
/// boundaries "left", "right", "base", "surface" as in SeabedMesh; "top" has no nodes. A cell belongs to the region of its
/// centroid; the border of two regions is a line of the mesh where it divides bodies. The vertices at a rigid body lie on
/// its surface, and the ends of a flat bottom that lies on the surface of the bed are vertices. The size of the cells is
/// that of the seabed, and not more than contact_size + growth * distance from a rigid body. mesh.geo, mesh.msh and mesh.log
/// are stored in `work_folder`. A mesh of another kind, whose holes exist already, is made by make_mesh.
///
/// Throws InputError where a rigid body is a half-plane, does not lie in the soil (in large deformations above it), or is too large for
/// contact_size; RunError where making the mesh fails.
mesh::Mesh<2> make_cut_mesh(const settings::Case& c, const std::filesystem::path& case_folder, const std::filesystem::path& work_folder);

/// The distance from the surface of a shape (m): the smallest of these formulas of x and y, which Gmsh evaluates.
std::vector<std::string> distances_from(const bodies::RigidShape<2>& shape);

/// Where the corners of a polygon lie, m.
std::vector<Vec<2>> corners_of(const bodies::Polygon<2>& polygon);

/// The size of the elements at a rigid body, or of all where there is none, m; 0 where neither the case nor its mesh names one.
Real contact_size_of(const settings::Case& c);

}  // namespace berm::fem
