// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/pipe_in_clay.hpp"
#include "formulas/pipe_in_sand.hpp"

// Vertical (section 4.2) and lateral resistance (4.4) of exposed pipes by DNV-RP-F114, as implemented in public programs.

namespace berm::formulas {

/// Bearing width of the pipe, m: B = 2 sqrt(D w - w^2) for w < D/2, else D. Zero at w = 0, NaN above the surface. (equation 4.3)
Real f114_contact_width(Real diameter, Real embedment);

/// Area of the soil that the pipe displaces, m2: with sin a = B/D, A_bm = a D^2/4 - (B D/4) cos a for w < D/2, else pi D^2/8
/// + D (w - D/2): above its centre the pipe counts as a vertical wall. NaN above the surface. (equation 4.7)
Real f114_penetrated_area(Real diameter, Real embedment);

/// The factor F >= 1 for strength that grows with depth, over x = k B/s_u0, of an interface from smooth (0) to rough (1), linear in the roughness between: in ln(1 + x)
/// linear between entries of a table, exact for a strip footing up to x = 8, of the figure at x = 16. [fit: DNV-RP-F114, figure 4-4; Davis and Booker 1973]
Formula f114_strength_factor(Real x, Real roughness);

/// The undrained vertical resistance by bearing capacity (model 1), N/m, upwards: Q_v = Q_v0 (1 + d) + gamma' A_bm,
/// Q_v0 = F (N_c s_u0 + k B/4) B, k the strength gradient, d = 0.3 (s_u1/s_u2) atan(z/B), s_u0 the strength at z, F of k B/s_u0,
/// s_u1 the mean of those at the surface and at z, s_u2 = Q_v0/(B N_c), z = 0 for w < (D/2)(1 - sqrt(2)/2), else w + (D/2)(sqrt(2) - 1) - B/2.
/// [fit: DNV-RP-F114]
Formula f114_undrained_model_1(const PipeInClay& pipe, Real N_c = 2 + pi);

/// The undrained vertical resistance of a pushed pipe, with heave (model 2), N/m, upwards, s_u that at the invert: Q_v =
/// min(6 (w/D)^0.25, 3.4 (10 w/D)^0.5) D s_u + 1.5 gamma' A_bm. [fit: DNV-RP-F114]
Formula f114_undrained_model_2(const PipeInClay& pipe);

/// Whose N_gamma a drained resistance takes: the recommended practice leaves it to the theory of footings.
enum class SelfWeight : std::uint8_t { hansen, vesic };

/// The drained vertical resistance, N/m, upwards: Q_v = gamma' N_gamma B^2/2 + z0 gamma' N_q d_q B, d_q = 1 + 1.2 (z0/B) tan phi (1 - sin phi)^2.
/// With a = pi/4 + phi/2, z0 = 0 for w < (D/2)(1 - cos a), else w - D/2 + [(D/2)/sin a - B/2] tan a. [fit: DNV-RP-F114]
Formula f114_drained_vertical(const PipeInSand& pipe, SelfWeight self_weight = SelfWeight::hansen);

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
