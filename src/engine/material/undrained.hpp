// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"
#include "material/elasticity.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

namespace berm::material {

/// K_w / n over the P-wave modulus of the skeleton where the input has no bulk modulus: an undrained Poisson's ratio of 0.495 for soil of 0.3.
constexpr Real stiffness_over_skeleton = 30;

/// A law that knows total stresses alone: its strength is undrained already.
template <class L>
constexpr bool total_stress_alone = requires
{
  L::total_stress_alone;
};

/// The void ratio that the input gives, of laws that have one.
template <Law L>
std::optional<Real> void_ratio(const L& law)
{
  if constexpr (requires { std::optional<Real>(law.void_ratio); }) return law.void_ratio;
  return {};
}

/// Whether excess pore pressure follows from the deformation of this soil.
template <Law L>
bool has_pore_pressure(const L& law)
{
  return !total_stress_alone<L> && law.water && law.water->drainage != Drainage::drained;
}

/// The porosity that the input gives.
template <Law L>
std::optional<Real> porosity(const L& law)
{
  const std::optional<Real> e = void_ratio(law);
  return e ? *e / (1 + *e) : law.water ? law.water->porosity : std::nullopt;
}

/// Of soil whose water flows; else empty.
template <Law L>
std::optional<Hydraulics> hydraulics(const L& law)
{
  if (!has_pore_pressure(law) || law.water->drainage != Drainage::consolidation) return {};
  return Hydraulics{law.water->permeability.value(), porosity(law).value(), law.water->kozeny_carman};
}

/// K_w / n, Pa; 0 where the soil has no excess pore pressure.
template <Law L>
Real water_stiffness(const L& law)
{
  if (!has_pore_pressure(law)) return 0;
  if (!law.water->bulk_modulus) return stiffness_over_skeleton * p_wave_modulus(elasticity(law));
  return *law.water->bulk_modulus / porosity(law).value_or(1);
}

/// What does not depend on the law, and what does: whether it knows effective stress, what its porosity is, and whether it ever fails undrained.
struct SoilForWater {
  bool effective_stress, dilates, stiffness_varies, has_void_ratio;
};
void check_water(Describe& d, const std::string& path, const std::optional<PoreWater>& water, const SoilForWater& soil);

/// The checks of the table `water` of a law at `path` ("material.sand").
template <Law L>
void check_water(Describe& d, const std::string& path, const L& law)
{
  bool stiffness_varies = false;
  if constexpr (KnowsDepth<L>) stiffness_varies = !law.profile.young_modulus.empty() || law.young_modulus_gradient != 0;
  const std::optional<Strength> strength = strength_at_rest(law);
  const bool effective = !total_stress_alone<L> && !(strength && strength->friction_angle == 0);
  check_water(d, path, law.water, {effective, dilates(law), stiffness_varies, void_ratio(law).has_value()});
}

/// A law of effective stress with water in its pores: precomputed constants. Stresses are total ones less the hydrostatic pressure; the last state
/// variable is the excess pore pressure p, Pa, compression positive.
template <class P>
struct Undrained {
  static constexpr int state_size = P::state_size + 1, local_size = material::local_size<P>();
  static constexpr bool elastic_is_largest = requires { P::elastic_is_largest; };

  P skeleton;
  decltype(P::elastic) elastic;  ///< of skeleton and water together
  Real stiffness = 0;            ///< K_w / n, Pa
  Real min_pressure = 0;         ///< Pa
};

/// The first of the six state variables of a law (xx yy zz xy yz zx) that are a tensor and rotate with the soil, where it has as many in use; none: -1.
template <class P>
constexpr int rotating_state = [] {
  if constexpr (requires { P::rotating_state; }) return P::rotating_state;
  return -1;
}();
template <class P>
constexpr int rotating_state<Undrained<P>> = rotating_state<P>;

template <class P>
constexpr int state_count(const Undrained<P>& law)
{
  return state_count(law.skeleton) + 1;
}

/// The prepared law `skeleton` with water of the stiffness K_w / n in its pores.
template <class P>
Undrained<P> with_water(const P& skeleton, Real stiffness, Real min_pressure)
{
  auto elastic = skeleton.elastic;
  elastic.bulk += stiffness;
  elastic.lame += stiffness;
  return {skeleton, elastic, stiffness, min_pressure};
}

template <class P, class T>
[[gnu::always_inline]] inline auto with_local(const Undrained<P>& law, const T* own)
{
  return with_water(with_local(law.skeleton, own), law.stiffness, law.min_pressure);
}

/// Advances the total stress (Pa, tension positive): with the strain increment e, that of the cell after the volumetric projection,
///
///   sigma' = sigma + p I,   sigma' by the law,   p = max(p - (K_w / n) (tr(e) + outflow + out), min_pressure),   sigma = sigma' - p I,
///
/// where `out` goes to the other particles of the cell: (K_w / n) out = x / (1 + x) (p - level), x = (K_w / n) exchange.
template <int dim, class P, class T>
[[gnu::always_inline]] inline void update(const Undrained<P>& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment, T* state)
{
  T& pressure = state[state_count(law.skeleton)];
  for (int k = 0; k < 3; ++k) stress[k] += pressure;
  update(law.skeleton, stress, increment, state);
  const T x = law.stiffness * increment.exchange + T{};
  pressure += x / (1 + x) * (increment.level - pressure) - law.stiffness * (trace(increment.strain) + increment.outflow);
  pressure = larger(pressure, T{} + law.min_pressure);
  for (int k = 0; k < 3; ++k) stress[k] -= pressure;
}

}  // namespace berm::material
