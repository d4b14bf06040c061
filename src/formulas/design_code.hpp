// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/pipe_in_clay.hpp"
#include "formulas/pipe_in_sand.hpp"

// Formulas of DNV-RP-F114 for pipes on the seabed, as implemented in public programs.

namespace berm::formulas {

/// Bearing width of the pipe, m: B = 2 sqrt(D w - w^2) for w < D/2, else D. Zero at w = 0, NaN above the surface.
Real f114_contact_width(Real diameter, Real embedment);

/// Area of the soil that the pipe displaces, m2: with sin a = B/D, A_bm = a D^2/4 - (B D/4) cos a for w < D/2, else pi D^2/8
/// + D (w - D/2): above its centre the pipe counts as a vertical wall. NaN above the surface.
Real f114_penetrated_area(Real diameter, Real embedment);

/// The undrained vertical resistance by bearing capacity (model 1), N/m, upwards: Q_v = Q_v0 (1 + d) + gamma' A_bm,
/// Q_v0 = F (N_c s_u0 + k B/4) B, N_c = 2 + pi, k the strength gradient, d = 0.3 (s_u1/s_u2) atan(z/B), s_u0 the strength at z,
/// s_u1 the mean of those at the surface and at z, s_u2 = Q_v0/(B N_c), z = 0 for w < (D/2)(1 - sqrt(2)/2), else w + (D/2)(sqrt(2) - 1) - B/2.
/// F is the factor of Davis and Booker for strength that grows with depth, 1 where it does not. [fit: DNV-RP-F114]
Formula f114_undrained_model_1(const PipeInClay& pipe, Real F);

/// The undrained vertical resistance of a pushed pipe, with heave (model 2), N/m, upwards, s_u that at the invert: Q_v =
/// min(6 (w/D)^0.25, 3.4 (10 w/D)^0.5) D s_u + 1.5 gamma' A_bm. [fit: DNV-RP-F114]
Formula f114_undrained_model_2(const PipeInClay& pipe);

/// The drained vertical resistance, N/m, upwards: Q_v = gamma' N_gamma B^2/2 + z0 gamma' N_q d_q B, d_q = 1 + 1.2 (z0/B) tan phi (1 - sin phi)^2.
/// With a = pi/4 + phi/2, z0 = 0 for w < (D/2)(1 - cos a), else w - D/2 + [(D/2)/sin a - B/2] tan a. The recommended practice leaves
/// N_gamma to the theory of footings; here it is n_gamma_hansen. [fit: DNV-RP-F114]
Formula f114_drained_vertical(const PipeInSand& pipe);

/// The drained horizontal resistance under a vertical load V, N/m, against the motion: H = F_p + tan delta max(0, V - tan delta F_p),
/// F_p = K_p gamma' w^2/2, K_p = (1 + sin phi)/(1 - sin phi). [fit: DNV-RP-F114]
Formula f114_drained_lateral(const PipeInSand& pipe, Real V);

/// Horizontal displacement at breakout, m.
struct Breakout {
  Formula min, mean, max;
};

/// Minimum D (0.004 + 0.02 w/D), mean D (0.02 + 0.25 w/D), maximum D (0.1 + 0.7 w/D). [fit: DNV-RP-F114]
Breakout f114_breakout(Real diameter, Real embedment);

}  // namespace berm::formulas
