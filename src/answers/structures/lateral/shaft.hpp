// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetrometer.hpp"

namespace berm::lateral {

/// A pile with a closed end: q_b = V over the area of its base, N_c = (q_b - sigma_v0)/s_u in clay, N_q = (q_b - sigma_v0)/sigma_v0 in sand.
const penetration::Penetrometer& pile();

/// A body that is open below: the skirt of a footing, a caisson, a pipe pile. q_b = V over the area of its tip, the ring, without the friction of both faces; factors as of a pile.
const penetration::Penetrometer& skirt();

/// A body that may be pushed down and read as resistance over depth, and loaded sideways where it stands in the bed. A run that does both has the results of both.
base::Structure shaft(const penetration::Penetrometer& how);

}  // namespace berm::lateral
