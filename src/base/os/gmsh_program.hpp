// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/child_process.hpp"

#include <filesystem>
#include <optional>

namespace berm {

/// Whose geometry gmsh runs: a user's may start programs and write files.
enum class GeometryBy { berm, user };

/// Runs the gmsh program to mesh the geometry `geo` into `msh` (format 4.1), in triangles (dim = 2) or tetrahedra (dim = 3);
/// its output goes to a .log beside `msh`, and a user's geometry writes nowhere but to that folder (os/case_programs.hpp). The user's own Gmsh options are ignored. Throws RunError where
/// gmsh is not installed or fails.
void run_gmsh(const std::filesystem::path& geo, const std::filesystem::path& msh, int dim, GeometryBy whose);

/// A gmsh program that waits for the next geometry: most of the time of a small mesh is the start of the program.
class WaitingGmsh {
public:
  /// Geometries and meshes are files of this folder. The program starts with the first geometry, and ends with this.
  explicit WaitingGmsh(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Meshes a geometry of berm in triangles, to the same bytes as run_gmsh. The names are those of files in the folder. Throws RunError where gmsh is not installed or fails.
  void mesh(const std::string& geo, const std::string& msh);

private:
  void start();
  void hand_over(const std::string& commands);
  void check_alive();

  std::filesystem::path folder_;
  std::optional<ChildProcess> gmsh_;
};

}  // namespace berm
