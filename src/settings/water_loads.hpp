// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

// Forces of moving water on a pipe that lies on the seabed and may move.

namespace berm::settings {

/// The parts of the loads that are left where the pipe is embedded by w/D, lies in a trench of a depth over D with walls of an angle (rad), or on a seabed through which water flows (formulas: f109_load_reductions).
struct WaterReductions {
  Real horizontal = 1, vertical = 1;
};
WaterReductions water_reductions(Real embedment, Real trench_depth, Real trench_angle, bool permeable);

/// Coefficients of the forces of water on the driven pipe of a stage.
struct WaterSettings {
  Real density = 1025;                   ///< kg/m3
  Real drag = 0, inertia = 0, lift = 0;  ///< C_D, C_M, C_L
  Real weight = 0;                       ///< N/m, submerged
  bool permeable = false;
  Real trench_depth = 0, trench_angle = 0;  ///< m, rad
};

/// Water far from the pipe, across it.
struct WaterMotion {
  Real velocity = 0, acceleration = 0;  ///< m/s, m/s2
};

/// N/m, across the pipe and down.
struct WaterForce {
  Real H = 0, V = 0;
};

/// Morison's equation with the velocity of the water relative to the pipe, and what the present embedment leaves of it:
///
///   H = r_y (rho D/2 C_D |U - v| (U - v) + rho pi D^2/4 C_M dU/dt),   V = w_s - r_z rho D/2 C_L (U - v)^2,
///
/// D (m), velocity v of the pipe (m/s), embedment w (m; above the seabed as on it). The added mass (C_M - 1) rho pi D^2/4 belongs to the mass of the pipe. [Morison and others 1950; DNV-RP-F109]
WaterForce water_force(const WaterSettings& water, const WaterMotion& motion, Real diameter, Real velocity, Real embedment);

/// kg/m: the mass that a force moves of a pipe of this weight in water, with displaced water and added mass, w_s/g + C_M rho pi D^2/4.
Real mass_in_water(const WaterSettings& water, Real diameter);

void describe(Describe& d, WaterSettings& water);

}  // namespace berm::settings
