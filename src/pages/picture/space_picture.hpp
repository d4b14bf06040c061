// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "problem/case.hpp"

#include <filesystem>

namespace berm::picture {

/// Writes a .png or .svg: the model of a case in space before its run, isometric: the box of the mesh with its dimensions, the soil's boxes, rigid bodies (drawn
/// whole, also where soil hides them), the ways that stages drive, and the stages in words. Throws RunError where it cannot be written, KeyError where a support refers
/// to no boundary of the mesh.
void draw_space(const problem::Case& c, const mesh::Mesh<3>& mesh, const std::filesystem::path& file);

}  // namespace berm::picture
