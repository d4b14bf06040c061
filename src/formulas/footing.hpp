// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

namespace berm::formulas {

/// The bearing capacity factor of surcharge, N_q = exp(pi tan phi) tan^2(pi/4 + phi/2). Friction angle in rad. [exact: Prandtl, Reissner]
Formula n_q(Real friction_angle);

/// The bearing capacity factor of cohesion, N_c = (N_q - 1) cot phi; 2 + pi for phi = 0. Friction angle in rad. [exact: Prandtl]
Formula n_c(Real friction_angle);

/// Roughness of the base of a footing.
enum class Base : std::uint8_t { smooth, rough };

/// The bearing capacity factor of self-weight of a strip footing on associated soil, q = gamma B N_gamma / 2, tabulated at 30 and 35 degrees;
/// between and beyond ln N_gamma is linear in phi. Friction angle in rad. [exact at the entries: characteristics]
Formula n_gamma(Real friction_angle, Base base);

/// The same factor as in design codes, N_gamma = 1.5 (N_q - 1) tan phi. Friction angle in rad. [fit: Brinch Hansen 1970]
Formula n_gamma_hansen(Real friction_angle);

/// The same by N_gamma = 2 (N_q + 1) tan phi, which is larger. Friction angle in rad. [fit: Vesic 1973]
Formula n_gamma_vesic(Real friction_angle);

/// q/s_u0 of a round footing (diameter D) on clay without weight whose strength grows with depth, s_u = s_u0 + k z; table at k D/s_u0 of 0, 1, 2, 4 and 8, between them
/// straight in ln(1 + k D/s_u0): 5.689 smooth and 6.048 rough in uniform clay. [exact at the entries: characteristics]
Formula n_c_circle(Real kD_over_strength, Base base);

/// The same of a strip of width B: 2 + pi in uniform clay. [exact at the entries: characteristics]
Formula n_c_strip(Real kB_over_strength, Base base);

/// Net N_c of a footing whose base is at a depth z in uniform clay, 5 (1 + 0.2 z/B) of a strip and 6 (1 + 0.2 z/D) of a circle, to z = 2.5 B and constant below: 7.5 and 9. [fit: Skempton 1951]
Formula n_c_skempton(Real z_over_B, bool round);

/// V/(B s_u) of a rough strip on uniform clay without weight under a horizontal load h = H/(B s_u) in the middle of its base,
///
///   1 + pi/2 + acos h + sqrt(1 - h^2),
///
/// from 2 + pi to half of it, below which it slides. Where the base carries less than s_u it slides at that h. [exact: Green 1954]
Formula n_c_inclined(Real h);

/// M/(B^2 s_u) of the same strip under v = V/(B s_u) and h together, about the middle of the base: v (1 - b)/2, where n_c_inclined on the effective width b B carries v and h, and
/// b = h where the base slides. A lower bound, for a base that carries no tension too. [exact, as a bound: a stress field on a part of the base]
Formula strip_moment_on_effective_width(Real v, Real h);

/// M/(B^2 s_u) of a strip that sticks to its base, for V = H = 0: the smallest a/(2 sin^2 a), which is that of tan a = 2 a, of a circular arc with half the angle a through both edges. An upper
/// bound. [exact, as a bound: a mechanism]
Formula strip_moment_of_arc();

/// N_gamma of a round footing on associated sand, q = gamma D N_gamma/2, tabulated at 20, 30 and 35 degrees; between them ln N_gamma is linear in phi. Friction angle
/// in rad. [exact at the entries: characteristics]
Formula n_gamma_circle(Real friction_angle, Base base);

}  // namespace berm::formulas
