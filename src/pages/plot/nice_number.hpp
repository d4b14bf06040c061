// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::plot {

/// The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten, for the end of an axis or of a range of colours; 1 where there is nothing to show.
Real round_up(Real value);

}  // namespace berm::plot
