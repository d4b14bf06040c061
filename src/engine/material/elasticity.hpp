// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lane_parts.hpp"
#include "core/tensor.hpp"

namespace berm::material {

/// The moduli of an isotropic linear elastic solid, Pa; N is a vector where particles have moduli of their own.
template <class N>
struct ElasticityOf {
  N bulk{}, shear{};
  N lame{};  ///< K - 2G/3
};
using Elasticity = ElasticityOf<Real>;

/// The same solid with Young's modulus times a factor.
template <class N>
[[gnu::always_inline]] inline ElasticityOf<N> scaled(const Elasticity& elastic, const N& factor)
{
  return {elastic.bulk * factor, elastic.shear * factor, elastic.lame * factor};
}

/// K = E / (3 (1 - 2 nu)), G = E / (2 (1 + nu)); E in Pa, nu in [0, 0.5).
inline Elasticity elasticity(Real young_modulus, Real poisson_ratio)
{
  const Real bulk = young_modulus / (3 * (1 - 2 * poisson_ratio)), shear = young_modulus / (2 * (1 + poisson_ratio));
  return {bulk, shear, bulk - 2. / 3 * shear};
}

/// E = 9 K G / (3 K + G), Pa.
inline Real young_modulus(const Elasticity& elastic)
{
  return 9 * elastic.bulk * elastic.shear / (3 * elastic.bulk + elastic.shear);
}

/// The modulus of uniaxial strain M = K + 4G/3 = E (1 - nu) / ((1 + nu) (1 - 2 nu)), Pa; sqrt(M / density) is the speed of pressure waves.
inline Real p_wave_modulus(const Elasticity& elastic)
{
  return elastic.lame + 2 * elastic.shear;
}

/// Hooke's law: lame tr(strain) I + 2G strain, Pa, tension positive.
template <int dim, class N, class T>
[[gnu::always_inline]] inline SymTensor<dim, T> elastic_stress(const ElasticityOf<N>& elastic, const SymTensor<dim, T>& strain)
{
  const T pressure = elastic.lame * trace(strain);
  const N two_shear = 2 * elastic.shear;
  SymTensor<dim, T> stress;
  for (int k = 0; k < 3; ++k) stress[k] = pressure + two_shear * strain[k];
  for (int k = 3; k < tensor_size<dim>; ++k) stress[k] = two_shear * strain[k];
  return stress;
}
template <int dim, class N, class T>
[[gnu::always_inline]] inline void add_elastic_stress(const ElasticityOf<N>& elastic, SymTensor<dim, T>& stress,
                                                      const SymTensor<dim, T>& strain)
{
  const SymTensor<dim, T> change = elastic_stress(elastic, strain);
  for (int k = 0; k < tensor_size<dim>; ++k) stress[k] += change[k];
}

}  // namespace berm::material
