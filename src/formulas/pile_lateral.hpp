// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <span>

// Resistance of soil to a pile that is pushed sideways: p, N per metre of depth, over its displacement y at that depth.

namespace berm::formulas {

/// A pile, and clay beside it at a depth.
struct ClayAtPile {
  Real z = 0;                     ///< m below the bed
  Real diameter = 0, length = 0;  ///< m, of the length in the bed
  Real strength = 0;              ///< s_u there, Pa
  Real strength_at_bed = 0;       ///< Pa
  Real overburden = 0;            ///< effective vertical stress there, Pa
  Real adhesion = 1;              ///< alpha of the shaft, 0 to 1
  Real strain_50 = 0;             ///< axial strain of a triaxial test at half of its strength
  Real small_strain_modulus = 0;  ///< G_0, Pa
  bool gap = true;                ///< the clay parts from the pile behind it
};

/// A pile, and sand beside it at a depth.
struct SandAtPile {
  Real z = 0;                     ///< m below the bed
  Real diameter = 0, length = 0;  ///< m, of the length in the bed
  Real friction_angle = 0;        ///< rad
  Real overburden = 0;            ///< effective vertical stress there, Pa
  Real relative_density = nan;    ///< 0 to 1
  Real small_strain_modulus = 0;  ///< G_0, Pa
};

/// N_p = p_u/(s_u D) = min(3 + sigma_v/s_u + J z/D, 9), J = 0.5 in soft clay and 0.25 in stiffer. [fit: Matlock 1970]
Formula matlock_factor(const ClayAtPile& clay, Real J = 0.5);
/// p = 0.5 p_u (y/y_c)^(1/3), y_c = 2.5 eps_50 D, p_u from y = 8 y_c on; static. [fit: API RP 2GEO, Matlock 1970]
Formula matlock_resistance(const ClayAtPile& clay, Real y);
/// The same, but straight to 0.23 p_u at y = 0.1 y_c. [fit: DNV-RP-C212]
Formula dnv_clay_resistance(const ClayAtPile& clay, Real y);

/// N_p = 12 - 4 exp(-xi z/D), xi = 0.25 + 0.05 s_u0 z/((s_u - s_u0) D), at most 0.55. [fit: Jeanjean 2009]
Formula jeanjean_factor(const ClayAtPile& clay);
/// p = p_u tanh(G_0/(100 s_u) (y/D)^0.5). [fit: Jeanjean 2009]
Formula jeanjean_resistance(const ClayAtPile& clay, Real y);

/// N_p0 = 12 - (1 - alpha) - 8.78 (1 - (z/(d D))^0.6)^1.35, d = 16.8 - 2.3 log10(s_u0 z/((s_u - s_u0) D)), 14.5 at least; N_p = N_p0 + sigma_v/s_u with a gap behind the pile, else 2 N_p0, at most
/// 9 + 3 alpha, as is N_p0. Strength the same in all directions. [fit: Jeanjean and others 2017, ISO 19901-4]
Formula iso_clay_factor(const ClayAtPile& clay);
/// p/p_u over y/D, a table of clay of I_p > 30 and OCR up to 2; straight between its entries. [fit: the same]
Formula iso_clay_resistance(const ClayAtPile& clay, Real y);

/// N_p = N_1 - N_2 exp(-xi z/D) + sigma_v/s_u, at most N_1 = 9 + 3 alpha, N_1 - N_2 = 2 + 1.5 alpha, xi as of jeanjean_factor. [recalled: Murff and Hamilton 1993]
Formula murff_hamilton_factor(const ClayAtPile& clay);

/// y over x from 0 with slope k to (x_u, y_u), and y_u beyond it; n from 0 (straight to y_u) to 1 curves it:
///
///   -n (y/y_u - x/x_u)^2 + (1 - n) (y/y_u - k x/y_u) (y/y_u - 1) = 0.
struct Conic {
  Real x_u, k, n, y_u;
  Real at(Real x) const;
};

/// Reactions of the PISA model, dimensionless: p and m along the shaft, H and M of the base. In clay p/(s_u D) over (y/D) G_0/s_u, m/(s_u D^2) over (tilt) G_0/s_u, H/(s_u D^2) over the argument of p,
/// M/(s_u D^3) over that of m; in sand sigma_v for s_u, and m/(|p| D). NaN: not known.
struct PisaReactions {
  Conic p, m, base_H, base_M;
};
PisaReactions pisa_cowden(Real z_over_D, Real L_over_D);
PisaReactions pisa_bothkennar(Real z_over_D, Real L_over_D);
PisaReactions pisa_dunkirk(Real z_over_D, Real L_over_D, Real relative_density);

/// How the soil holds a pile at a depth, by a method. What it does not have is null.
template <class Soil>
struct PileMethod {
  const char* name;                                          ///< "Jeanjean 2009"
  const char* column;                                        ///< of tables: "jeanjean_2009"
  const char* choices;                                       ///< that it makes beyond the soil of the case
  Formula (*p)(const Soil& soil, Real y);                    ///< N/m
  Formula (*m)(const Soil& soil, Real tilt) = nullptr;       ///< N m/m, against the tilt
  Formula (*base_H)(const Soil& soil, Real y) = nullptr;     ///< N, with the soil at the base
  Formula (*base_M)(const Soil& soil, Real tilt) = nullptr;  ///< N m, the same
};
std::span<const PileMethod<ClayAtPile>> clay_pile_methods();
std::span<const PileMethod<SandAtPile>> sand_pile_methods();

/// p = A p_u tanh(k z y/(A p_u)), p_u = min(C_1 z + C_2 D, C_3 D) sigma_v, A = 3 - 0.8 z/D, 0.9 at least, static; k of sand below water. C_1 to C_3 of wedges with K_0 = 0.4, angles phi/2 and
/// 45 deg + phi/2. [fit: API RP 2GEO, after O'Neill and Murchison 1983]
Formula api_sand_resistance(const SandAtPile& sand, Real y);
/// p_u of the same, N/m.
Formula api_sand_limit(const SandAtPile& sand);
/// [fit: Burd and others 2020, PISA, Dunkirk sand]
Formula pisa_sand_resistance(const SandAtPile& sand, Real y);

/// eps_50 of clay without hardening, s_u/(3 G): that of its law.
inline Real strain_50_of(Real rigidity_index)
{
  return 1 / (3 * rigidity_index);
}

}  // namespace berm::formulas
