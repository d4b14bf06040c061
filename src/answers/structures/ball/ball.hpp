// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::ball {

/// A ball that is pushed in: q over its largest section, N_ball = q/s_u less the weight of the soil that it displaces, over the depth of its centre.
const penetration::Reading& reading();

}  // namespace berm::ball
