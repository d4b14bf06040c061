// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/formulas/pipe_in_clay.hpp"
#include "structures/formulas/pipe_in_sand.hpp"

// Lateral resistance of exposed pipes by DNV-RP-F114, section 4.4, as implemented in public programs.

namespace berm::formulas {

/// What is behind a pipe that moves in clay.
enum class Rear : std::uint8_t {
  gap,     ///< the clay stands open: it does not pull
  suction  ///< the clay clings to the pipe
};

/// The undrained horizontal resistance at breakout by friction and pressure (model 1), N/m, against the motion: with a gap
/// H = r s_u B + w (c s_u' + gamma' w/2), with suction H = r s_u B + 2 w c s_u', s_u' the strength at half of the embedment and B the contact width; below w = D that of
/// the lowest D. c = 2, 2.25 and 2.5 for the low, best and high estimate. [fit: DNV-RP-F114]
Estimates f114_undrained_lateral_1(const PipeInClay& pipe, Rear rear);

/// The same by a fit (model 2, that of SAFEBUCK) under a vertical load V, N/m: with s_u at the invert
/// H = D s_u [1.7 (w/D)^0.61 + 0.23 (V/(D s_u))^0.83 + 0.6 (gamma' D/s_u)(w/D)^2]. [fit: DNV-RP-F114]
Formula f114_undrained_lateral_2(const PipeInClay& pipe, Real V);

/// The angle of which the passive pressure coefficient is made, K_p = (1 + sin)/(1 - sin).
enum class PassiveAngle : std::uint8_t {
  interface,  ///< that of the pipe's surface, as the public program has it
  soil        ///< Rankine's, of the sand: no public program has it
};

/// The drained horizontal resistance at breakout under a vertical load V, N/m, against the motion: H = F_p + tan delta max(0, V - tan delta F_p),
/// F_p = K_p gamma' w^2/2. The residual one is the same at the embedment that is left then. [fit: DNV-RP-F114; recalled for the angle of the soil]
Formula f114_drained_lateral(const PipeInSand& pipe, Real V, PassiveAngle angle = PassiveAngle::interface);

/// The undrained residual resistance after a sweep of some diameters under a vertical load V, N/m: H = V (0.32 + 0.8 (w/D)^0.8), over 1.5 and times 1.5.
/// [fit: DNV-RP-F114]
Estimates f114_clay_residual(const PipeInClay& pipe, Real V);

/// Horizontal displacement at breakout, m: D (0.004 + 0.02 w/D), D (0.02 + 0.25 w/D), D (0.1 + 0.7 w/D). [fit: DNV-RP-F114]
Estimates f114_breakout_displacement(Real diameter, Real embedment);

/// Horizontal displacement from which the resistance is residual, m: 0.6 D, 1.5 D, 2.8 D. [fit: DNV-RP-F114]
Estimates f114_residual_displacement(Real diameter);

}  // namespace berm::formulas
