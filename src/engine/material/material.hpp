// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/clay.hpp"
#include "material/law_list.hpp"
#include "material/linear_elastic.hpp"
#include "material/modified_cam_clay.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/norsand.hpp"
#include "material/user_law.hpp"

namespace berm::material {

/// The closed list of laws. Each law L has its word and parameters (`describe`), elasticity(L), prepare(L), and
///
///   update(prepared, stress, increment, state)
///
/// for T = Real, T = Lanes and, in plane strain, T = Dual, and with_own(prepared, own), the law of particles that keep
/// strength and stiffness for themselves; it overrides the queries of law_queries.hpp whose default does
/// not apply. Choose once per body with std::visit, outside the loop over particles.
using Laws = LawList<LinearElastic, MohrCoulomb, Clay, ModifiedCamClay, NorSand, UserLaw<Interface::umat>, UserLaw<Interface::own>>;

using Material = Laws::Material;
using PreparedMaterial = Laws::Prepared;

void describe(Describe& d, Material& material);

/// Checks beyond the range of a single key, for the table at `path` ("material.sand"): those of the law, and density <=
/// inertia_density.
void check(Describe& d, const std::string& path, const Material& material);

/// The law with precomputed constants.
PreparedMaterial prepare(const Material& material);

/// Density that gives the weight, kg/m3.
Real density(const Material& material);

/// Density that gives the inertia, kg/m3.
Real inertia_density(const Material& material);

/// Elastic moduli, of effective stress.
Elasticity elasticity(const Material& material);
YoungPoisson young_poisson(const Material& material);

/// P-wave modulus M, Pa, of the skeleton and of the water in its pores; sqrt(M / inertia density) is the speed of pressure waves where the water stays there.
Real p_wave_modulus(const Material& material);

/// Number of state variables per particle: those of the law, and the excess pore pressure where there is one.
int state_size(const Material& material);

// Water in the pores (material/undrained.hpp).
bool has_pore_pressure(const Material& material);
/// Of soil whose water flows; else empty.
std::optional<Hydraulics> hydraulics(const Material& material);
/// K_w / n, Pa; 0 where the soil has no excess pore pressure.
Real water_stiffness(const Material& material);
/// Which of the state variables is the excess pore pressure, Pa, compression positive; none where the soil has none.
int pore_pressure_place(const Material& material);
/// The same soil, from which water flows freely.
Material drained(Material material);
/// stress + p I of a soil with this state: the stress itself where the soil has no excess pore pressure. Pa, tension positive.
template <int dim>
SymTensor<dim> effective_stress(const Material& material, SymTensor<dim> stress, const Real* state)
{
  if (const int place = pore_pressure_place(material); place != none)
    for (int k = 0; k < 3; ++k) stress[k] += state[place];
  return stress;
}

/// The law's word in the input.
const char* law_word(const Material& material);

// The queries of law_queries.hpp.
std::string law_name(const Material& material);
std::vector<FieldInfo> state_fields(const Material& material);
void initial_state(const Material& material, const SymTensor<3>& stress, Real* state);
bool yields(const Material& material);
std::optional<Strength> strength_at_rest(const Material& material);
std::optional<Real> shear_strength(const Material& material, Real middle, const Real* state);
bool knows_rate(const Material& material);
Material with_rate_smoothing(const Material& material, Real time);
void recover(const Material& material, Real share, Real* state);
bool dilates(const Material& material);
Material without_dilation(const Material& material);

// Variation with depth (material/depth_profile.hpp).
bool varies(const Material& material);
Material at_depth(const Material& material, Real depth);
std::vector<Real> own_values(const Material& material);
std::vector<FieldInfo> own_fields(const Material& material);
Material with_own_values(const Material& material, const Real* own);

bool non_associated(const Material& material);
Material associated(const Material& material, const SymTensor<2>& stress);

}  // namespace berm::material
