// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"
#include "material/exponential.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"
#include "material/mohr_coulomb_return.hpp"

namespace berm::material {

/// Undrained clay: linear elasticity with a Tresca strength that rises with the rate of shearing and falls with remoulding,
///
///   (s1 - s3)/2 <= s_u = s_u0 (1 + rate_parameter log10(max(rate, reference_rate)/reference_rate)) (d + (1 - d) exp(-3 xi/ductility)),
///
/// d = 1/sensitivity; xi the plastic shear strain, the sum of the plastic parts of d(e1 - e3), so that `ductility` is the xi at which 95 % of the strength
/// that remoulding takes is lost; rate = rate_scale d(xi)/dt, smoothed over rate_smoothing. Strain of elastic soil, such as vibration, neither softens nor
/// strengthens it. [Einav and Randolph 2005; Zhou and Randolph 2009] (docs/theory/soil_and_contact.md, Clay)
///
/// State: xi, what the rate adds to the strength over it, and s_u/s_u0 - 1.
struct Clay {
  static constexpr const char* word = "clay";
  static constexpr const char* strength_key = "undrained_strength";
  static constexpr int state_size = 3;
  static constexpr bool total_stress_alone = true;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa; 0: by rigidity_index
  Real poisson_ratio = 0;
  std::optional<Real> rigidity_index;    ///< G / s_u0, instead of young_modulus
  Real undrained_strength = 0;           ///< s_u0, Pa: intact, up to the reference rate
  Real undrained_strength_gradient = 0;  ///< Pa/m, increase with depth below the bed's surface at the start
  Real sensitivity = 1;                  ///< intact over remoulded strength
  Real ductility = 0;                    ///< xi_95; 0 where the sensitivity is 1
  Real rate_parameter = 0;               ///< relative increase of the strength per tenfold rate
  Real reference_rate = 0;               ///< 1/s
  Real rate_scale = 1;                   ///< rate of the real motion divided by that of the model
  std::optional<Real> rate_smoothing;    ///< s; empty: 0 until with_rate_smoothing
  std::optional<Real> softening_length;  ///< m; empty: none
  Real young_modulus_gradient = 0;       ///< Pa/m, increase with depth
  ProfileOf<Clay> profile = {};
  std::optional<Shansep> shansep = {};  ///< instead of undrained_strength
  std::optional<PoreWater> water = {};

  bool operator==(const Clay&) const = default;
};

inline StrengthAtDepth strength_at_depth(Clay& law)
{
  return {&law.undrained_strength, &law.undrained_strength_gradient};
}

void describe(Describe& d, Clay& law);

/// Refuses stiffness given twice or not at all, softening or a rate effect without its measure, and softening that is faster than elastic unloading.
void check(Describe& d, const std::string& path, const Clay& law);

/// With the strength at a depth (m) under the weight of the soil above (Pa), and the stiffness that goes with it.
Clay at_depth(Clay law, Real depth, Real weight_above = 0);

/// Of soil at the bed's surface.
Elasticity elasticity(const Clay& law);
YoungPoisson young_poisson(const Clay& law);

std::vector<FieldInfo> state_fields(const Clay& law);
std::optional<Strength> strength_at_rest(const Clay& law);
std::optional<Real> shear_strength(const Clay& law, Real middle, const Real* state);

/// The undrained strength over the factor, intact and remoulded; the stiffness stays. Of slow shearing, as a load that lasts has it: a rate that adds strength would hide that the soil creeps.
std::optional<Clay> with_strength_over(Clay law, Real factor);

/// Smooths the rate over a time (s) where the input names none.
Clay with_rate_smoothing(Clay law, Real time);
inline bool is_rate_dependent(const Clay& law)
{
  return law.rate_parameter > 0;
}
/// The share is of the strength that softening took; xi becomes the plastic shear strain that leaves this strength.
void recover(const Clay& law, Real share, Real* state);

/// What is the same for all particles of a clay.
struct ClayConstants {
  Real remoulded = 1;                   ///< d, part of the strength that remains
  Real per_shear = 0;                   ///< 3 / ductility; 0: no softening
  Real per_e_fold = 0, per_relative{};  ///< rate_parameter / ln 10, and its inverse
  Real per_reference = 0;               ///< rate_scale / reference_rate, s
  Real smoothing = 0;                   ///< s
  Real softening_length = 0;            ///< m; 0: none
};

/// Precomputed constants; N is a vector where particles have a strength and a Young's modulus of their own.
template <class N>
struct PreparedClayOf : ClayConstants {
  static constexpr int state_size = 3, local_size = 2;

  ElasticityOf<N> elastic;
  PreparedMohrCoulombOf<N> tresca;  ///< intact, up to the reference rate
};
using PreparedClay = PreparedClayOf<Real>;

PreparedClay prepare(const Clay& law);

/// The law with the strength own[0] and Young's modulus own[1], Pa, of each lane.
template <class T>
[[gnu::always_inline]] inline PreparedClayOf<T> with_local(const PreparedClay& law, const T* own)
{
  const PreparedMohrCoulombOf<T> tresca = with_local(law.tresca, own);
  return {static_cast<const ClayConstants&>(law), tresca.elastic, tresca};
}

/// (s1 - s3)/2, Pa, of plane strain and of space.
template <class T>
[[gnu::always_inline]] inline T max_shear(const SymTensor<2, T>& stress)
{
  const T mean = (stress[0] + stress[1]) * 0.5, half = (stress[0] - stress[1]) * 0.5;
  const T radius = square_root(half * half + stress[3] * stress[3]);
  return (larger(mean + radius, stress[2]) - smaller(mean - radius, stress[2])) * 0.5;
}
template <class T>
[[gnu::always_inline]] inline T max_shear(const SymTensor<3, T>& stress)
{
  const Principal<T> s = principal(axis_and_circle(stress));
  return (s.s1 - s.s3) * 0.5;
}

/// The strength at the end of an increment over s_u0, as a function of its plastic shear strain x:
/// (1 + rate part) (d + (1 - d) exp(-per_shear (xi + weight x))).
template <class T>
struct ClayStrength {
  T relative{}, slope{}, rate_part{}, rate_slope{};

  /// kept: the smoothed rate without the increment over the reference rate; per_x: what a unit of x adds to that; damage: exp(-per_shear xi).
  [[gnu::always_inline]] ClayStrength(const ClayConstants& law, const T& x, const T& kept, const Real& per_x, const T& damage,
                                      const Real& weight)
  {
    T of_shear = T{} + 1., slope_of_shear{};
    if (law.per_shear > 0) {
      const T left = (1 - law.remoulded) * damage * exponential(-law.per_shear * weight * x);
      of_shear = law.remoulded + left;
      slope_of_shear = -law.per_shear * weight * left;
    }
    if (law.per_e_fold > 0) {
      constexpr Real rounding = 1e-9;  // at the reference rate itself the slope is that of the faster side
      const T one = T{} + 1., rate = kept + per_x * x;
      rate_part = law.per_e_fold * logarithm(larger(rate, one));
      rate_slope = rate > one - rounding ? law.per_e_fold * per_x / larger(rate, one) : T{};
    }
    relative = (1 + rate_part) * of_shear;
    slope = rate_slope * of_shear + (1 + rate_part) * slope_of_shear;
  }
};

/// Plastic shear strain x of an increment from `shear` = (s1 - s3)/2 of its elastic trial stress: the root of shear - G x = s_u(x), by Newton's method on the
/// side of the kink, where the rate reaches its reference, on which the root lies. It starts from the strength that the soil had, `begin` over s_u0. The constants
/// are a copy, so that the law of a part of a cell, whose particles have a strength of their own, is made in registers.
template <class T>
[[gnu::noinline]] T plastic_shear(const ClayConstants law, const T strength, const T stiffness, const T& shear, const T& begin,
                                  decltype(T{} < T{}) yields, const T& kept, const Real& per_x, const T& damage, const Real& weight,
                                  T& rate_part)
{
  // Newton's method squares an error: from 1e-7 of the strength, what is left is below 1e-12 of it.
  constexpr Real precision = 1e-7, flattest = 0.1;
  const T zero{};
  decltype(yields) beyond = yields, left = yields;
  T reaches{};
  if (per_x > 0 && any(yields & (kept < T{} + 1.))) {
    reaches = larger((1. - kept) / per_x, zero);
    beyond = shear - stiffness * reaches > strength * ClayStrength<T>(law, reaches, kept, per_x, damage, weight).relative;
  }
  const T least = beyond ? reaches : zero, most = beyond ? infinity - zero : reaches;
  T x = smaller(larger((shear - strength * begin) / stiffness, least), most);
  // A particle that has converged does not change any more, so that it does not depend on the others.
  for (int n = 0; n < 50 && any(left); ++n) {
    const ClayStrength<T> now(law, x, kept, per_x, damage, weight);
    const T residual = shear - stiffness * x - strength * now.relative;
    const T slope = larger(stiffness + strength * now.slope, flattest * stiffness);
    const T better = smaller(larger(x + residual / slope, least), most);
    rate_part = left ? now.rate_part + now.rate_slope * (better - x) : rate_part;
    x = left ? better : x;
    left = left & (magnitude(residual) > precision * strength * now.relative);
  }
  return x;
}

/// Advances `stress` (Pa, tension positive) by an increment: elastic predictor, then the frictionless Mohr-Coulomb return to the strength at the end of the
/// increment. Without duration the rate stays what it was.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void update(const PreparedClayOf<N>& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  using Mask = decltype(T{} < T{});
  T &xi = state[0], &rate_part = state[1], &change = state[2];
  const T zero{};
  const Real since = increment.dt > 0 ? increment.dt / law.smoothing : 0;  // infinity without smoothing
  T begin = 1 + change, begin_rate{};
  const bool has_rate = any(rate_part > zero);
  if (has_rate) {
    begin_rate = larger(rate_part - law.per_e_fold * since, zero);
    begin = begin * (1 + begin_rate) / (1 + rate_part);
  }
  add_elastic_stress(law.elastic, stress, increment.strain);
  const T shear = max_shear(stress), strength = law.tresca.strength * begin;
  const Mask yields = shear > strength;
  if (!any(yields)) [[likely]] {
    if (has_rate) rate_part = begin_rate, change = begin - 1.;
    return;
  }
  const T kept = law.per_e_fold > 0 ? exponential(rate_part * law.per_relative - since) : zero;
  const Real per_x = law.per_e_fold > 0 && increment.dt > 0 ? -std::expm1(-since) * law.per_reference / increment.dt : 0;
  const Real weight = law.softening_length > 0 && increment.cell_size > 0 ? increment.cell_size / law.softening_length : 1;
  const T damage = law.per_shear > 0 ? exponential(-law.per_shear * xi) : zero;
  T of_flow{};
  const T x = plastic_shear<T>(law, law.tresca.strength - T{}, law.elastic.shear - T{}, shear, T(1 + change), yields, kept, per_x, damage,
                               weight, of_flow);
  const T flowing = shear - law.elastic.shear * x;
  xi = yields ? xi + weight * x : xi;
  rate_part = yields ? of_flow : begin_rate;
  constexpr Real no_strength = 1e-6;  // Pa
  change = yields ? flowing / larger(law.tresca.strength - T{}, T{} + no_strength) - 1. : begin - 1.;
  T opening{};
  return_to_surface(law.tresca, T(yields ? flowing : law.tresca.strength * begin), stress, opening);
}

}  // namespace berm::material
