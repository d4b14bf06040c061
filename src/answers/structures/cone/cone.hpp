// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::cone {

/// A cone with its shaft, pushed in as in a cone penetration test: q_t over the depth of its shoulder, N_kt = (q_t - sigma_v0)/s_u in clay, Q_t = (q_t - sigma_v0)/sigma_v0 in sand.
const penetration::Reading& reading();

}  // namespace berm::cone
