// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Throws InputError where k0 stresses (InitialState::level_ground) do not fit the ground: along vertical lines through the bodies that fill regions the weight
/// of the soil above is compared with density gravity (surface - y). Lines through rigid bodies are left out.
template <int dim>
void refuse_k0_below_uneven_ground(const settings::Case& c, const Model<dim>& model);

/// Moduli of soil that under its own weight, held at its sides, has sigma_xx = sigma_zz = k0 sigma_yy, over its vertical modulus of uniaxial strain:
///
///   s_yy = e_yy + k0 (e_xx + e_zz),  s_xx = along e_xx + across e_zz + k0 e_yy,  s_zz = across e_xx + along e_zz + k0 e_yy,  s_xy = 2 shear e_xy.
///
/// Up to k0 = 0.8 this is isotropic with Poisson's ratio k0 / (1 + k0). Beyond, where that comes near incompressibility (k0 = 1), it is stiffer along the horizontal.
struct GroundElasticity {
  Real modulus;  ///< Pa
  Real k0, along, across, shear;
};
GroundElasticity ground_elasticity(const material::Material& material, Real k0);

/// Stress of a strain, Pa.
template <int dim>
SymTensor<dim> stress_of(const GroundElasticity& ground, const SymTensor<dim>& strain);

/// InitialState::gravity_loading for particles: gives all particles of a cell the stress with which the nodes of bodies with k0 are in equilibrium with gravity and the supports
/// of the first stage, as the method sees them (volumes and weights of particles, the volumetric projection), soil being GroundElasticity. Bodies joined by a
/// contact move as one at the nodes that they share. The strength is not looked at. Throws InputError where supports do not hold a body.
template <int dim>
void load_by_gravity(const settings::Case& c, const Model<dim>& model, std::vector<bodies::Particles<dim>>& particles);

}  // namespace berm::problem
