// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetrometer.hpp"

namespace berm::penetration {

/// A cone with its shaft, pushed in as in a cone penetration test: q_t over the depth of its shoulder, N_kt = (q_t - sigma_v0)/s_u in clay, Q_t = (q_t - sigma_v0)/sigma_v0 in sand.
const Penetrometer& cone();

/// A ball that is pushed in: q over its largest section, N_ball = q/s_u less the weight of the soil that it displaces, over the depth of its centre.
const Penetrometer& ball();

/// A bar that is pushed across itself (plane strain): q = V/D, N_Tbar = q/s_u less the weight of the soil that it displaces, over the depth of its axis.
const Penetrometer& t_bar();

/// A footing or plate, strip or round: q = V over its area, N_c = (q - sigma_v0)/s_u on clay, N_gamma = 2 (q - sigma_v0)/(gamma' D) on sand; beside what any push and drag have.
const Penetrometer& footing();

}  // namespace berm::penetration
