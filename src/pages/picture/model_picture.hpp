// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "problem/ground.hpp"
#include "settings/case.hpp"

#include <filesystem>

namespace berm::picture {

/// Width of the picture, pixels; its height follows from what it shows.
constexpr int picture_width = 1400;

/// Writes a .png or .svg: the model of a case in the plane before its run, to scale. The mesh with the soils that fill it, supports, tractions, rigid bodies with
/// their dimensions, contacts, the ways that stages drive, and what all of that is in words. Throws RunError where it cannot be written, KeyError where a name of the
/// case refers to nothing in the mesh.
void draw_model(const settings::Case& c, const mesh::Mesh<2>& mesh, const std::filesystem::path& file);

/// A case on a page, from what its file says alone; of one in space the plane x-y.
struct PageDrawing {
  std::string
      svgs;  ///< SVG elements: the whole; where the driven body is small in it, what is around its way; of a pipeline the plan of its line
  std::vector<std::string> notes;  ///< what is not drawn, in words (plain text)
};

/// The same without cells and numbers of soils. `bed`: that of a run, where more is known of it than the case says; `title` (plain text) is for those who cannot see
/// it. Cases that look the same are drawn the same.
PageDrawing draw_on_page(const settings::Case& c, const problem::Ground& bed, const std::string& title);

/// Writes a .png or .svg: the model of a case in space before its run, isometric: the box of the mesh with its dimensions, the soil's boxes, rigid bodies (drawn
/// whole, also where soil hides them), the ways that stages drive, and the stages in words. Throws RunError where it cannot be written, KeyError where a support refers
/// to no boundary of the mesh.
void draw_space(const settings::Case& c, const mesh::Mesh<3>& mesh, const std::filesystem::path& file);

}  // namespace berm::picture
