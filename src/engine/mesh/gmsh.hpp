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
  std::vector<std::string> axes = {};        ///< the file's coordinates that become x, y and z: "x", "-z"; empty: x, y and z
  Real scale = 1;                            ///< m over the file's unit
  std::vector<Real> shift = {};              ///< m, of the mesh once scaled
  std::optional<Real> merge_tolerance = {};  ///< m: nodes no farther apart become one; empty: doubled nodes are refused
  std::optional<SeabedMesh> made_from = {};  ///< of a file that berm made: from what
};

void describe(Describe& d, GmshFile& mesh);

/// Refuses axes that are none of a mesh in `dimension` directions.
void check_axes(Describe& d, const std::string& path, const std::vector<std::string>& axes, int dimension);

/// Reads a mesh of Gmsh's format 4.1 in ASCII, coordinates in metres; in 2D it lies in the plane z = 0. Triangles (2D) or
/// tetrahedra (3D) of named physical groups become cells, the group their region; nodes of named groups of lower dimension
/// become boundaries. Other entities are ignored. Of cells of second order the corners are taken; those of a partitioned mesh
/// are taken as if it were not. Throws InputError with file and line for anything else. Source: Gmsh reference manual, MSH
/// file format.
template <int dim>
Mesh<dim> read_msh(const std::filesystem::path& path);

/// The same of a user's file, with its coordinates as the settings change them. Refuses nodes that lie at one place, where parts of the mesh do not hold together.
template <int dim>
Mesh<dim> read_msh(const std::filesystem::path& path, const GmshFile& settings);

}  // namespace berm::mesh
