// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "run_folder/history.hpp"
#include "run_folder/run_folder.hpp"

#include <string>

namespace berm::soil_plot {

/// Width and height of a picture of panels, pixels.
constexpr int panels_width = 1200, panels_height = 900;

/// Where a panel lies on the canvas, in parts of it.
struct PanelPlace {
  Real left, right, bottom, top;
};

/// The commands of gnuplot that put the next plot there.
std::string margins(const PanelPlace& place);

/// The commands that begin a picture of several panels under one title; `push` and `drag` are colours in them.
std::string begin_panels(const std::string& title);

/// curves.png of any run: the columns named against time, one panel for each unit. False, with a warning, where it could not be drawn.
bool draw_columns(const run_folder::RunFolder& folder, const run_folder::History& history, const std::vector<std::string>& columns,
                  const std::string& title);

}  // namespace berm::soil_plot
