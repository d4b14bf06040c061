// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"
#include "material/mohr_coulomb_return.hpp"

namespace berm::material {

/// Undrained clay whose strength increases with strain rate: linear elasticity with Tresca strength, perfectly plastic,
///
///   (s1 - s3)/2 <= s_u,   s_u = undrained_strength (1 + rate_parameter log10(rate / reference_rate)),   rate = sqrt(2 e:e) / dt,
///
/// e the deviator of the strain increment; in pure shear sqrt(2 e:e) is the engineering shear strain. Below the reference
/// rate, and for an increment without duration, s_u = undrained_strength. The strength depends on the current increment
/// alone. Source of the rate law: Einav and Randolph, Int. J. Numer. Meth. Engng 63 (2005).
///
/// State: the strength that the rate of the last increment added, Pa.
struct RateDependentTresca {
  static constexpr const char* word = "rate_dependent_tresca";
  static constexpr const char* strength_key = "undrained_strength";
  static constexpr int state_size = 1;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa
  Real poisson_ratio = 0;
  Real undrained_strength = 0;           ///< Pa, up to the reference rate
  Real undrained_strength_gradient = 0;  ///< Pa/m, increase with depth below the bed's surface at the start
  Real rate_parameter = 0;               ///< relative increase of the strength per tenfold rate
  Real reference_rate = 0;               ///< 1/s
  Real young_modulus_gradient = 0;       ///< Pa/m, increase with depth
  ProfileOf<RateDependentTresca> profile = {};

  bool operator==(const RateDependentTresca&) const = default;
};

inline StrengthAtDepth strength_at_depth(RateDependentTresca& law)
{
  return {&law.undrained_strength, &law.undrained_strength_gradient};
}

void describe(Describe& d, RateDependentTresca& law);

inline Elasticity elasticity(const RateDependentTresca& law)
{
  return elasticity(law.young_modulus, law.poisson_ratio);
}

std::string law_name(const RateDependentTresca& law);
std::vector<FieldInfo> state_fields(const RateDependentTresca& law);
std::optional<Strength> strength_at_rest(const RateDependentTresca& law);
std::optional<Real> shear_strength(const RateDependentTresca& law, Real middle, const Real* state);

/// Precomputed constants; N is a vector where particles have a strength and a Young's modulus of their own.
template <class N>
struct PreparedRateDependentTrescaOf {
  static constexpr int state_size = 1, own_size = 2;

  ElasticityOf<N> elastic;
  PreparedMohrCoulombOf<N> tresca;  ///< up to the reference rate
  N per_decade{};                   ///< Pa, strength increase per tenfold rate
  Real reference_rate = 0;          ///< 1/s
  Real rate_parameter = 0;
};
using PreparedRateDependentTresca = PreparedRateDependentTrescaOf<Real>;

PreparedRateDependentTresca prepare(const RateDependentTresca& law);

/// The law with the strength own[0] and Young's modulus own[1], Pa, of each lane.
template <class T>
[[gnu::always_inline]] inline PreparedRateDependentTrescaOf<T> with_own(const PreparedRateDependentTresca& law, const T* own)
{
  const PreparedMohrCoulombOf<T> tresca = with_own(law.tresca, own);
  return {tresca.elastic, tresca, law.rate_parameter * own[0], law.reference_rate, law.rate_parameter};
}

/// Advances `stress` (Pa, tension positive) by an increment: elastic predictor, then the frictionless Mohr-Coulomb return to
/// the strength at the increment's rate. state[0] becomes the strength that the rate adds, Pa.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void update(const PreparedRateDependentTrescaOf<N>& law, SymTensor<dim, T>& stress,
                                          const Increment<dim, T>& increment, T* state)
{
  T& added = state[0];
  added = T{};
  if (increment.dt > 0) {
    SymTensor<dim, T> deviator = increment.strain;
    const T mean = trace(deviator) * (1. / 3), one = T{} + 1.;
    for (int k = 0; k < 3; ++k) deviator[k] -= mean;
    const T rate = square_root(double_dot(deviator, deviator) * 2.) / (increment.dt * law.reference_rate);
    if (any(rate > one)) added = law.per_decade * decimal_logarithm(larger(rate, one));
  }
  add_elastic_stress(law.elastic, stress, increment.strain);
  const T strength = law.tresca.strength + added;
  T opening{};
  return_to_surface(law.tresca, strength, stress, opening);
}

}  // namespace berm::material
