// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/plot/isometric_raster_test.cpp
#pragma once

#include "core/types.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace berm::plot {

/// Red, green and blue, 0 to 255.
using Rgb = std::array<Real, 3>;

/// The colour at a part from 0 to 1 of viridis, which is even to the eye and in grey; the nearest end beyond them.
Rgb viridis(Real part);

/// The command of gnuplot that makes these colours its palette.
std::string viridis_palette();

/// Where the colours of values begin and end: at zero, and beyond it where one value in a hundred lies farther; at the farthest where all but those are
/// zero. There must be a value.
std::pair<Real, Real> color_range(std::vector<Real> values);

}  // namespace berm::plot
