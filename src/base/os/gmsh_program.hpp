// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace berm {

/// Whose geometry gmsh runs: a user's may start programs and write files.
enum class GeometryBy { berm, user };

/// Runs the gmsh program to mesh the geometry `geo` into `msh` (format 4.1), in triangles (dim = 2) or tetrahedra (dim = 3);
/// its output goes to a .log beside `msh`, and a user's geometry writes nowhere but to that folder (os/case_programs.hpp). The user's own Gmsh options are ignored. Throws RunError where
/// gmsh is not installed or fails.
void run_gmsh(const std::filesystem::path& geo, const std::filesystem::path& msh, int dim, GeometryBy whose);

}  // namespace berm
