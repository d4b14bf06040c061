// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "plot/gnuplot.hpp"
#include "problem/case.hpp"

namespace berm::picture {

/// FOLDER/NAME.png or .svg: the model of a case in space before its run, isometric: the box of the mesh with its dimensions, the soil's boxes, rigid bodies (drawn
/// whole, also where soil hides them), the ways that stages drive, and the stages in words. Script and data go to FOLDER/plots. False, with a warning, where gnuplot
/// does not draw. Throws KeyError where a support refers to no boundary of the mesh.
bool draw_space(const problem::Case& c, const mesh::Mesh<3>& mesh, const std::filesystem::path& folder, const std::string& name,
                plot::PlotFormat format);

}  // namespace berm::picture
