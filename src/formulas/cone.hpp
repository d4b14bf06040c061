// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// What soil a cone penetration test met, and its parameters: p_a = 100 kPa, stresses in Pa, ratios of friction as numbers (0.01 is 1 %).

namespace berm::formulas {

/// Normalized resistance and friction, the stress exponent n and the index of soil behaviour I_c: Q_tn = (q_t - sigma_v0)/p_a (p_a/sigma'_v0)^n, F_r = f_s/(q_t - sigma_v0),
/// n = 0.381 I_c + 0.05 sigma'_v0/p_a - 0.15 <= 1, I_c^2 = (3.47 - log10 Q_tn)^2 + (log10 F_r[%] + 1.22)^2, solved for n. Not valid where q_t <= sigma_v0 or f_s <= 0. [fit: Robertson 2009]
struct SoilBehaviour {
  Real Q_tn, F_r, n;
  Formula I_c;
};
SoilBehaviour soil_behaviour(Real q_t, Real f_s, Real sigma_v0, Real effective_stress);

/// Zone of soil behaviour type by I_c: 7 below 1.31, 6 to 2.05, 5 to 2.60, 4 to 2.95, 3 to 3.60, 2 above; and its name. From I_c = 2.60 on, zones 4 to 2, soil is taken as undrained. [fit: Robertson 1990, 2009]
int zone_of(Real I_c);
const char* name_of_zone(int zone);
constexpr Real end_of_sand = 2.60;
constexpr Real zone_ends[] = {1.31, 2.05, end_of_sand, 2.95, 3.60};  ///< I_c, of zone 7 to 3

/// Total unit weight, gamma/gamma_w = 0.27 log10 R_f[%] + 0.36 log10(q_t/p_a) + 1.236, R_f = f_s/q_t. [fit: Robertson and Cabal 2010]
Formula cone_unit_weight(Real q_t, Real f_s, Real gamma_w);

/// Relative density of sand of medium compressibility: D_r = 0.268 ln((q_t/p_a)/sqrt(sigma'_v0/p_a)) - 0.675. [fit: Jamiolkowski and others 2001]
Formula cone_relative_density(Real q_t, Real effective_stress);

/// Young's modulus at some 0.1 % of strain of young uncemented sand: E = 0.015 10^(0.55 I_c + 1.68) (q_t - sigma_v0), I_c < 2.60. [fit: Robertson 2009]
Formula cone_modulus(Real I_c, Real net_resistance);

}  // namespace berm::formulas
