// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>

namespace berm::record {

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

}  // namespace berm::record
