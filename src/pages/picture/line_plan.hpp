// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/canvas.hpp"
#include "settings/case.hpp"

namespace berm::picture {

/// The half of the line of a case, which has one, from above: imperfection, slices, springs beyond, and what holds its ends. To scale along it, and sideways as many times larger as it says. Drawn
/// from an upper left corner downwards within a width; gives the level where it ends, pixels.
Real draw_line_plan(Canvas& canvas, const settings::Case& c, const Vec<2>& at, Real width);

}  // namespace berm::picture
