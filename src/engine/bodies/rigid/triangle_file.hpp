// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/triangle_mesh.hpp"

#include <filesystem>

namespace berm::bodies {

/// The triangles of a file: STL, as text or binary, or Wavefront OBJ, whose polygons become fans of triangles. Points with the same coordinates are one. Throws
/// InputError with the file and the line where it is neither.
Triangles read_triangles(const std::filesystem::path& file);

}  // namespace berm::bodies
