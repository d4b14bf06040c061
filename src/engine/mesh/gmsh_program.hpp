// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/gmsh.hpp"

#include <filesystem>
#include <string>

namespace berm::mesh {

/// Whose geometry gmsh runs: a user's may start programs and write files.
enum class Geometry { own, of_user };

/// Runs the gmsh program to mesh the geometry `geo` into `msh` (format 4.1), in triangles (dim = 2) or tetrahedra (dim = 3);
/// its output goes to a .log beside `msh`, and a user's geometry writes nowhere but to that folder (os/case_programs.hpp). The user's own Gmsh options are ignored. Throws RunError where
/// gmsh is not installed or fails.
void run_gmsh(const std::filesystem::path& geo, const std::filesystem::path& msh, int dim, Geometry whose);

/// Runs it, unless the same mesh is kept (kept_meshes.hpp), and reads what it made, by the settings of a user's file where there are some. Throws KeyError with the key that the geometry comes from where that cannot be
/// used: the file is berm's own.
template <int dim>
Mesh<dim> mesh_by_gmsh(const std::filesystem::path& geo, const std::filesystem::path& msh, const std::string& key,
                       const GmshFile* settings = nullptr);

}  // namespace berm::mesh
