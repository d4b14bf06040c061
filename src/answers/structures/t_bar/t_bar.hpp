// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::t_bar {

/// A bar that is pushed across itself (plane strain): q = V/D, N_Tbar = q/s_u less the weight of the soil that it displaces, over the depth of its axis.
const penetration::Reading& reading();

}  // namespace berm::t_bar
