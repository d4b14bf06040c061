// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Loads of waves and current on a pipe that lies on the seabed, and the weight that holds it, by DNV-RP-F109.

namespace berm::formulas {

/// One oscillation of the water at the pipe: K = U T/D, M = V/U, U amplitude of the oscillation, T its period, V the current.
struct PeakLoads {
  Formula horizontal, vertical;  ///< C_Y, C_Z
};

/// C_Y and C_Z of the largest loads in an oscillation, F = C rho D/2 (U + V)^2: a table over K and M, straight between its entries; below K = 2.5 C_Y is that at 2.5 times 2.5/K, C_Z that at
/// 2.5; beyond K = 140 and M = 10 that at the end. Not valid where both K < 2.5 and M > 10: hardly a wave. [fit: DNV-RP-F109]
PeakLoads f109_peak_loads(Real K, Real M);

/// The parts of the loads that are left where the pipe is embedded by w/D, lies in a trench of a depth over D with walls of an angle (rad, 5 to 45 deg), or on a seabed through which water flows:
/// horizontal max(1 - 1.4 w/D, 0.3) (1 - 0.18 (angle - 5)^0.25 (z_t/D)^0.42), vertical max(1 - 1.3 (w/D - 0.1), 0) from 0.1 on (1 - 0.14 (angle - 5)^0.43 (z_t/D)^0.46), times 0.7 where water
/// flows, angles in deg. [fit: DNV-RP-F109]
struct LoadReductions {
  Formula horizontal, vertical;
};
LoadReductions f109_load_reductions(Real embedment, Real trench_depth, Real trench_angle, bool permeable);

/// L = w_s/(rho D/2 U_s^2) of a pipe on sand that moves less than half a diameter in a sea state, with K = U_s T_u/D, M = V/U_s and N = U_s/(g T_u): tables of L/(2 + M)^2 over K from 10 on, and over N
/// to K = 5, straight between. M is 0.2 at least in the tables. [fit: DNV-RP-F109]
Formula f109_weight_for_half_diameter(Real K, Real M, Real N);

}  // namespace berm::formulas
