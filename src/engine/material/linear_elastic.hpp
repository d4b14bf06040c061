// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"
#include "material/elasticity.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

namespace berm::material {

/// Isotropic linear elasticity: parameters.
struct LinearElastic {
  static constexpr const char* word = "linear_elastic";
  static constexpr const char* strength_key = nullptr;
  static constexpr int state_size = 0;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa
  Real poisson_ratio = 0;
  Real young_modulus_gradient = 0;  ///< Pa/m, increase with depth
  ProfileOf<LinearElastic> profile = {};
  std::optional<PoreWater> water = {};

  bool operator==(const LinearElastic&) const = default;
};

void describe(Describe& d, LinearElastic& law);

inline StrengthAtDepth strength_at_depth(LinearElastic&)
{
  return {};
}

/// Precomputed constants; N is a vector where particles have a Young's modulus of their own.
template <class N>
struct PreparedLinearElasticOf {
  static constexpr int state_size = 0, local_size = 1;

  ElasticityOf<N> elastic;
  Real per_young_modulus = 0;  ///< 1/Pa
};
using PreparedLinearElastic = PreparedLinearElasticOf<Real>;

inline Elasticity elasticity(const LinearElastic& law)
{
  return elasticity(law.young_modulus, law.poisson_ratio);
}

inline bool yields(const LinearElastic&)
{
  return false;
}

inline PreparedLinearElastic prepare(const LinearElastic& law)
{
  return {elasticity(law), 1 / law.young_modulus};
}

/// The law with Young's modulus own[0], Pa, of each lane.
template <class T>
[[gnu::always_inline]] inline PreparedLinearElasticOf<T> with_local(const PreparedLinearElastic& law, const T* own)
{
  return {scaled(law.elastic, own[0] * law.per_young_modulus), law.per_young_modulus};
}

/// Adds the elastic stress increment to `stress` (Pa, tension positive). No state; the last argument is ignored.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void update(const PreparedLinearElasticOf<N>& law, SymTensor<dim, T>& stress,
                                          const Increment<dim, T>& increment, T* /*state*/)
{
  add_elastic_stress(law.elastic, stress, increment.strain);
}

}  // namespace berm::material
