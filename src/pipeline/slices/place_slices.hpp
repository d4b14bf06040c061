// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::slices {

/// Gives slices places of which the case says only how many (pipeline.slices.count). The line goes through its stages on the springs of the far soil until the largest compression of all is there. Then each piece
/// between two slices has the same share of
///
///   1/2 (1/X + int |dH/dx| dt / int int |dH/dx| dt dx),
///
/// with the resistance H of the springs sideways and the place X of the last slice: half of the slices lie evenly, half where H changes along the line, as at turning points, whose H changes its sign. X is `to`;
/// without it a tenth beyond the last place where a spring has had 40 % of its resistance. Throws KeyError where that cannot be found.
void place_slices(settings::Case& c);

}  // namespace berm::slices
