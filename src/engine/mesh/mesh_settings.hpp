// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/box.hpp"
#include "mesh/gmsh.hpp"
#include "mesh/seabed.hpp"

namespace berm::mesh {

/// Where the background mesh comes from.
using MeshSettings = std::variant<SeabedMesh, GmshFile, BoxMesh>;

void describe(Describe& d, MeshSettings& mesh);

/// Makes or reads the mesh. A mesh from or for Gmsh is stored in `work_folder` as mesh.msh (with mesh.log where Gmsh made
/// it, and mesh.geo where berm did). A relative path is relative to `case_folder`. Throws InputError where the settings or
/// the user's file are wrong, RunError where making the mesh fails.
template <int dim>
Mesh<dim> make_mesh(const MeshSettings& settings, const std::filesystem::path& case_folder, const std::filesystem::path& work_folder);

/// Meshes a geometry by gmsh, or takes the cached mesh (os/mesh_cache.hpp), and reads it, by the settings of a user's file where there are some. Throws KeyError with the key that the geometry comes
/// from where the mesh cannot be used: the file is berm's own.
template <int dim>
Mesh<dim> mesh_by_gmsh(const std::filesystem::path& geo, const std::filesystem::path& msh, const std::string& key,
                       const GmshFile* settings = nullptr);

}  // namespace berm::mesh
