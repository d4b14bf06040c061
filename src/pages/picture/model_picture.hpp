// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "plot/gnuplot.hpp"
#include "problem/case.hpp"

namespace berm::picture {

/// Width of the picture, pixels; its height follows from what it shows.
constexpr int picture_width = 1400;

/// FOLDER/NAME.png or .svg: the model of a case in the plane before its run, to scale. The mesh with the soils that fill it, supports, tractions, rigid bodies with
/// their dimensions, contacts, the ways that stages drive, and what all of that is in words. Script and data go to FOLDER/plots. False, with a warning, where
/// gnuplot does not draw. Throws KeyError where a name of the case refers to nothing in the mesh.
bool draw_model(const problem::Case& c, const mesh::Mesh<2>& mesh, const std::filesystem::path& folder, const std::string& name,
                plot::PlotFormat format);

}  // namespace berm::picture
