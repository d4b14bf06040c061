// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/elasticity.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

namespace berm::material {

/// Isotropic linear elasticity: parameters.
struct LinearElastic {
  static constexpr const char* word = "linear_elastic";
  static constexpr int state_size = 0;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa
  Real poisson_ratio = 0;
};

void describe(Describe& d, LinearElastic& law);

/// Precomputed constants.
struct PreparedLinearElastic {
  static constexpr int state_size = 0;

  Elasticity elastic;
};

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
  return {elasticity(law)};
}

/// Adds the elastic stress increment to `stress` (Pa, tension positive). No state; the last argument is ignored.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedLinearElastic& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* /*state*/)
{
  add_elastic_stress(law.elastic, stress, increment.strain);
}

}  // namespace berm::material
