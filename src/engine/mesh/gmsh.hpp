// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/mesh.hpp"
#include "mesh/seabed.hpp"

#include <filesystem>

namespace berm::mesh {

/// A mesh made with Gmsh, or a geometry that Gmsh is to mesh.
struct GmshFile {
  std::string file;                          ///< .msh, format 4.1, ASCII; or .geo
  std::optional<SeabedMesh> made_from = {};  ///< of a file that berm made: from what
};

void describe(Describe& d, GmshFile& mesh);

/// Reads a mesh of Gmsh's format 4.1 in ASCII, coordinates in metres; in 2D it lies in the plane z = 0. Triangles (2D) or
/// tetrahedra (3D) of named physical groups become cells, the group their region; nodes of named groups of lower dimension
/// become boundaries. Other entities are ignored. Throws InputError with file and line for anything else. Source: Gmsh
/// reference manual, MSH file format.
template <int dim>
Mesh<dim> read_msh(const std::filesystem::path& path);

}  // namespace berm::mesh
