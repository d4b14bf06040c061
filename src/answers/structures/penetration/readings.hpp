// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::penetration {

/// A cone with its shaft, pushed in as in a cone penetration test: q_t over the depth of its shoulder, N_kt = (q_t - sigma_v0)/s_u in clay, Q_t = (q_t - sigma_v0)/sigma_v0 in sand.
const Reading& cone_reading();

/// A ball that is pushed in: q over its largest section, N_ball = q/s_u less the weight of the soil that it displaces, over the depth of its centre.
const Reading& ball_reading();

/// A bar that is pushed across itself (plane strain): q = V/D, N_Tbar = q/s_u less the weight of the soil that it displaces, over the depth of its axis.
const Reading& t_bar_reading();

}  // namespace berm::penetration
