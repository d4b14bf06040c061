// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>

namespace berm::plot {

/// The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten, for the end of an axis or of a range of colours; 1 where there is nothing to show.
Real round_up(Real value);

/// What the numbers of an axis count from: 0, or a round number where the axis is so far from the origin that they would have no room.
Real axis_base(Real from, Real to);

/// The title of such an axis: x (mm), or x - 500000 m (mm).
std::string axis_title(const std::string& name, Real base, const std::string& unit);

}  // namespace berm::plot
