// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::lateral {

/// A pile with a closed end: q_b = V over the area of its base, N_c = (q_b - sigma_v0)/s_u in clay, N_q = (q_b - sigma_v0)/sigma_v0 in sand.
const penetration::Reading& pile_reading();

}  // namespace berm::lateral
