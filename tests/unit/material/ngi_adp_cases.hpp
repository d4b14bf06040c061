// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/anisotropic_clay.hpp"

namespace berm::material {

constexpr Real active_strength = 2e4;

/// Begins with the shear stress at which all that fails by simple shear stays at yield in the same direction: tau_0 = (s_A - s_P)/2.
inline NgiAdp centred_ngi_adp()
{
  return sample_ngi_adp((1 - 0.35) / 2);
}

/// The stress at rest with this (vertical less horizontal stress)/2, compression positive, Pa.
inline SymTensor<3> stress_at_rest(Real shear, Real pressure = 5e4)
{
  return {{2. / 3 * shear - pressure, -4. / 3 * shear - pressure, 2. / 3 * shear - pressure}};
}

/// Soil at rest, which strains.
template <int dim>
struct AdpElement {
  NgiAdp law;
  PreparedNgiAdp prepared = prepare(law);
  SymTensor<dim> stress;
  Real state[1] = {};

  explicit AdpElement(const NgiAdp& soil) : AdpElement(soil, stress_at_rest(soil.initial_mobilisation * soil.undrained_strength)) {}
  AdpElement(const NgiAdp& soil, const SymTensor<3>& begin) : law(soil)
  {
    for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = begin[k];
    initial_state(law, begin, state);
  }

  void strain_by(const SymTensor<dim>& strain) { update(prepared, stress, Increment<dim, Real>{strain}, state); }
  /// In equal steps.
  void strain_by(SymTensor<dim> strain, int steps)
  {
    for (int k = 0; k < tensor_size<dim>; ++k) strain[k] /= steps;
    for (int n = 0; n < steps; ++n) strain_by(strain);
  }
  /// (vertical less horizontal stress)/2, compression positive.
  Real half_difference() const { return (stress[0] - stress[1]) / 2; }
  Real kappa() const { return state[0] < 1 ? 2 * std::sqrt(state[0]) / (1 + state[0]) : 1; }
};

/// The strain of a test with shear strain 1: (vertical less horizontal strain, compression positive) and g_xy are cos and sin of the direction in plane strain.
template <int dim>
SymTensor<dim> plane_shear(Real direction, Real strain)
{
  SymTensor<dim> all{};
  all[0] = strain * std::cos(direction) / 2;
  all[1] = -all[0];
  all[3] = strain * std::sin(direction) / 2;
  return all;
}

/// Undrained triaxial compression, shear strain e1 - e3; extension where it is negative.
template <int dim>
SymTensor<dim> triaxial_shear(Real strain)
{
  SymTensor<dim> all{};
  all[0] = all[2] = strain / 3;
  all[1] = -2 * strain / 3;
  return all;
}

}  // namespace berm::material
