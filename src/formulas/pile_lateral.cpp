// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pile_lateral.hpp"

#include "formulas/points.hpp"

namespace berm::formulas {
namespace {

constexpr Source matlock{Label::fit, "API RP 2GEO, after Matlock 1970, static", "s_u <= 96 kPa"};
constexpr Source dnv{Label::fit, "DNV-RP-C212 (2019, amended 2021), static", "s_u <= 96 kPa"};
constexpr Source jeanjean{Label::fit, "Jeanjean 2009", "s_u <= 96 kPa"};
constexpr Source iso{Label::fit, "ISO 19901-4, after Jeanjean and others 2017",
                     "I_p > 30, OCR <= 2, 0 < s_u <= 100 kPa at the seabed and below"};
constexpr Source murff{Label::recalled, "Murff and Hamilton 1993", "s_u >= 0 at the seabed, increasing with depth"};
constexpr Source cowden{Label::fit, "PISA, Cowden till, Byrne and others 2020", "2 <= L/D <= 6"};
constexpr Source bothkennar{Label::fit, "PISA, Bothkennar clay, Burd and others 2020", "2 <= L/D <= 6"};
constexpr Source api_sand{Label::fit, "API RP 2GEO, after O'Neill and Murchison 1983, static", "29 <= phi <= 45 deg"};
constexpr Source dunkirk{Label::fit, "PISA, Dunkirk sand, Burd and others 2020", "2 <= L/D <= 6, 0.45 <= D_r <= 0.9"};

constexpr Real soft = 96e3, no_longer_soft = 100e3;  // Pa

/// A resistance of either sign of y.
Formula both_ways(Real y, Real size, const Source& source, bool in_range)
{
  return formula(std::copysign(size, y), source, in_range);
}

/// s_u0/(k D), k the mean growth of s_u from the bed to z; infinite where it does not grow.
Real bed_over_growth(const ClayAtPile& clay)
{
  const Real growth = (clay.strength - clay.strength_at_bed) * clay.diameter / clay.z;
  return growth > 1e-9 * clay.strength ? clay.strength_at_bed / growth : infinity;
}

Real wedge_exponent(const ClayAtPile& clay)
{
  return std::min(0.25 + 0.05 * bed_over_growth(clay), 0.55);
}

bool is_in_clay(const ClayAtPile& clay)
{
  return clay.z >= 0 && clay.diameter > 0 && clay.strength > 0;
}

bool is_of_pisa(Real L_over_D)
{
  return within(L_over_D, 2, 6);
}

}  // namespace

Formula matlock_factor(const ClayAtPile& clay, Real J)
{
  const Real N = 3 + clay.overburden / clay.strength + J * clay.z / clay.diameter;
  return formula(std::min(N, Real(9)), matlock, is_in_clay(clay) && clay.strength <= soft);
}

Formula matlock_resistance(const ClayAtPile& clay, Real y)
{
  const Formula N = matlock_factor(clay);
  const Real yc = 2.5 * clay.strain_50 * clay.diameter, part = std::min(0.5 * std::cbrt(std::abs(y) / yc), Real(1));
  return both_ways(y, part * N.value * clay.strength * clay.diameter, matlock, N.valid);
}

Formula dnv_clay_resistance(const ClayAtPile& clay, Real y)
{
  constexpr Real straight_to = 0.1, part_there = 0.23;
  const Formula curve = matlock_resistance(clay, y);
  const Real u = std::abs(y) / (2.5 * clay.strain_50 * clay.diameter);
  if (u > straight_to) return both_ways(y, std::abs(curve.value), dnv, curve.valid);
  const Real p_u = matlock_factor(clay).value * clay.strength * clay.diameter;
  return both_ways(y, part_there * u / straight_to * p_u, dnv, curve.valid);
}

Formula jeanjean_factor(const ClayAtPile& clay)
{
  return formula(12 - 4 * std::exp(-wedge_exponent(clay) * clay.z / clay.diameter), jeanjean, is_in_clay(clay) && clay.strength <= soft);
}

Formula jeanjean_resistance(const ClayAtPile& clay, Real y)
{
  const Formula N = jeanjean_factor(clay);
  const Real part = std::tanh(clay.small_strain_modulus / (100 * clay.strength) * std::sqrt(std::abs(y) / clay.diameter));
  return both_ways(y, part * N.value * clay.strength * clay.diameter, jeanjean, N.valid);
}

Formula iso_clay_factor(const ClayAtPile& clay)
{
  constexpr Real N1 = 12, N2 = 3.22, least_d = 14.5;
  const Real most = 9 + 3 * clay.adhesion, ratio = bed_over_growth(clay);
  const Real d = std::max(least_d, 16.8 - 2.3 * std::log10(ratio));
  const Real above = std::max(Real(0), 1 - std::pow(clay.z / (d * clay.diameter), 0.6));
  const Real N0 = std::min(most, N1 - (1 - clay.adhesion) - (N1 - N2) * std::pow(above, 1.35));
  const Real N = clay.gap ? N0 + clay.overburden / clay.strength : 2 * N0;
  return formula(std::min(most, N), iso,
                 is_in_clay(clay) && clay.strength_at_bed > 0 && within(clay.adhesion, 0, 1) && clay.strength <= no_longer_soft);
}

Formula iso_clay_resistance(const ClayAtPile& clay, Real y)
{
  constexpr std::array part{0., 0.05, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.975, 1.};
  constexpr std::array over_D{0., 0.0003, 0.003, 0.0053, 0.009, 0.014, 0.022, 0.032, 0.05, 0.082, 0.15, 0.25};
  const Formula N = iso_clay_factor(clay);
  return both_ways(y, along_points(over_D, part, std::abs(y) / clay.diameter) * N.value * clay.strength * clay.diameter, iso, N.valid);
}

Formula murff_hamilton_factor(const ClayAtPile& clay)
{
  const Real N1 = 9 + 3 * clay.adhesion, N2 = N1 - (2 + 1.5 * clay.adhesion);
  const Real N = N1 - N2 * std::exp(-wedge_exponent(clay) * clay.z / clay.diameter) + clay.overburden / clay.strength;
  return formula(std::min(N, N1), murff, is_in_clay(clay) && within(clay.adhesion, 0, 1));
}

Real Conic::at(Real x) const
{
  const Real size = std::abs(x);
  if (!(y_u > 0 && x_u > 0 && k > 0 && n >= 0 && n <= 1)) return nan;  // beyond the lengths that it was fitted to
  if (size >= x_u) return std::copysign(y_u, x);
  const Real u = size / x_u, s = k * size / y_u;
  const Real a = 1 - 2 * n, b = 2 * n * u - (1 - n) * (1 + s), c = (1 - n) * s - n * u * u;
  return std::copysign(y_u * 2 * c / (-b + std::sqrt(std::max(Real(0), b * b - 4 * a * c))), x);
}

PisaReactions pisa_cowden(Real z, Real L)
{
  const Real k_m = 1.420 - 0.09643 * z, m_u = 0.2899 - 0.04775 * z;
  return {{241.4, 10.6 - 1.650 * z, 0.9390 - 0.03345 * z, 10.7 - 7.101 * std::exp(-0.3085 * z)},
          {m_u / k_m, k_m, 0, m_u},
          {235.7, 2.717 - 0.3575 * L, 0.8793 - 0.03150 * L, 0.4038 + 0.04812 * L},
          {173.1, 0.2146 - 0.002132 * L, 1.079 - 0.1087 * L, 0.8192 - 0.08588 * L}};
}

PisaReactions pisa_bothkennar(Real z, Real L)
{
  const Real k_m = 1.698 - 0.1576 * z, m_u = 0.4862 - 0.05674 * z;
  return {{173.8, 12.05 - 1.547 * z, 0.7204 - 0.002679 * z, 7.743 - 3.945 * std::exp(-0.8456 * z)},
          {m_u / k_m, k_m, 0, m_u},
          {291.5, 3.008 - 0.2701 * L, 0.3113 + 0.04263 * L, 0.5279 + 0.06864 * L},
          {nan, nan, nan, nan}};
}

PisaReactions pisa_dunkirk(Real z, Real L, Real density)
{
  constexpr Real k_m = 17;
  const Real m_u = 0.2605 + (-0.1989 + 0.2019 * density) * z / L;
  return {{146.1 - 92.11 * density, 8.731 - 0.6982 * density - 0.9178 * z, 0.917 + 0.06193 * density,
           0.3667 + 25.89 * density + (0.3375 - 8.9 * density) * z / L},
          {m_u / k_m, k_m, 0, m_u},
          {0.5150 + 2.883 * density + (0.1695 - 0.7018 * density) * L, 6.505 - 2.985 * density - (0.007969 + 0.4299 * density) * L,
           0.09978 + 0.7974 * density + (0.004994 - 0.07005 * density) * L, 0.09952 + 0.7996 * density + (0.03988 - 0.1606 * density) * L},
          {44.89, 0.3515, 0.3 + 0.4986 * density, 0.09981 + 0.3710 * density + (0.01998 - 0.09041 * density) * L}};
}

namespace {

using PisaClay = PisaReactions (*)(Real z_over_D, Real L_over_D);

/// A reaction of PISA's clay: its conic at a displacement over D (or a tilt), times s_u D^power.
template <PisaClay model, Conic PisaReactions::*reaction, int power, const Source& source>
Formula in_clay(const ClayAtPile& clay, Real motion)
{
  constexpr bool rotates = reaction == &PisaReactions::m || reaction == &PisaReactions::base_M;
  const Real D = clay.diameter, L = clay.length / D, x = (rotates ? motion : motion / D) * clay.small_strain_modulus / clay.strength;
  return formula((model(clay.z / D, L).*reaction).at(x) * clay.strength * std::pow(D, power), source, is_in_clay(clay) && is_of_pisa(L));
}

}  // namespace

std::span<const PileMethod<ClayAtPile>> clay_pile_methods()
{
  using R = PisaReactions;
  static constexpr std::array<PileMethod<ClayAtPile>, 6> methods{{
      {"API RP 2GEO (Matlock)", "api", "J = 0.5, ε50 = sᵤ/(3G) of the case", matlock_resistance},
      {"DNV-RP-C212", "dnv", "J = 0.5, ε50 = sᵤ/(3G) of the case", dnv_clay_resistance},
      {"Jeanjean 2009", "jeanjean_2009", "G₀ = 550 sᵤ", jeanjean_resistance},
      {"ISO 19901-4 (Jeanjean 2017)", "iso", "I_p > 30, OCR up to 2, isotropic strength", iso_clay_resistance},
      {"PISA Cowden", "pisa_cowden", "G₀ = 550 sᵤ", in_clay<pisa_cowden, &R::p, 1, cowden>, in_clay<pisa_cowden, &R::m, 2, cowden>,
       in_clay<pisa_cowden, &R::base_H, 2, cowden>, in_clay<pisa_cowden, &R::base_M, 3, cowden>},
      {"PISA Bothkennar", "pisa_bothkennar", "G₀ = 550 sᵤ, without the moment of its base", in_clay<pisa_bothkennar, &R::p, 1, bothkennar>,
       in_clay<pisa_bothkennar, &R::m, 2, bothkennar>, in_clay<pisa_bothkennar, &R::base_H, 2, bothkennar>},
  }};
  return methods;
}

std::span<const PileMethod<SandAtPile>> sand_pile_methods()
{
  static constexpr std::array<PileMethod<SandAtPile>, 1> methods{
      {{"API RP 2GEO, sand", "api", "below water, K₀ = 0.4", api_sand_resistance}}};
  return methods;
}

Formula api_sand_limit(const SandAtPile& sand)
{
  constexpr Real K0 = 0.4;
  const Real phi = sand.friction_angle, alpha = phi / 2, beta = pi / 4 + phi / 2;
  const Real tan_b = std::tan(beta), tan_bf = std::tan(beta - phi), tan_f = std::tan(phi), Ka = 1 / (tan_b * tan_b);
  const Real C1 = tan_b * tan_b * std::tan(alpha) / tan_bf +
                  K0 * (tan_f * std::sin(beta) / (std::cos(alpha) * tan_bf) + tan_b * (tan_f * std::sin(beta) - std::tan(alpha)));
  const Real C2 = tan_b / tan_bf - Ka, C3 = Ka * (std::pow(tan_b, 8) - 1) + K0 * tan_f * std::pow(tan_b, 4);
  const Real value = std::min(C1 * sand.z + C2 * sand.diameter, C3 * sand.diameter) * sand.overburden;
  return formula(value, api_sand, sand.z >= 0 && within(phi, 29 * degree, 45 * degree));
}

Formula api_sand_resistance(const SandAtPile& sand, Real y)
{
  const Formula limit = api_sand_limit(sand);
  const Real phi = sand.friction_angle / degree;
  const Real k = std::max((0.1978 * phi - 10.232) * phi + 136.82, 5.4) * 1e6;  // N/m3
  const Real most = std::max(0.9, 3 - 0.8 * sand.z / sand.diameter) * limit.value;
  const Real value = most > 0 ? most * std::tanh(k * sand.z * std::abs(y) / most) : 0;
  return both_ways(y, value, api_sand, limit.valid);
}

Formula pisa_sand_resistance(const SandAtPile& sand, Real y)
{
  const Real D = sand.diameter, L = sand.length / D;
  const Conic p = pisa_dunkirk(sand.z / D, L, sand.relative_density).p;
  const Real value = sand.overburden > 0 ? p.at(y / D * sand.small_strain_modulus / sand.overburden) * sand.overburden * D : 0;
  return formula(value, dunkirk, sand.z >= 0 && is_of_pisa(L) && within(sand.relative_density, 0.45, 0.9));
}

}  // namespace berm::formulas
