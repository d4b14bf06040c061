// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace berm::mesh {

/// Ends a geometry whose cells are as large as the smallest of these formulas of x and y says, m: each less than a thousand characters, which is as many as Gmsh takes.
void end_geometry(std::ofstream& out, const std::vector<std::string>& sizes, const std::filesystem::path& path);

}  // namespace berm::mesh
